#include "render/context/egl.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <sstream>
#include <vector>

namespace server::render {
namespace {

class EglContext final : public GlContext {
public:
    EglContext(const Egl& egl, EGLDisplay display, EGLContext context, std::string description)
        : egl_(egl), display_(display), context_(context), description_(std::move(description)) {}
    ~EglContext() override {
        forget_current(*this);
        lose();
    }

    bool make_current() override {
        return context_ != EGL_NO_CONTEXT &&
               egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
    }
    void release() override { egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
    void lose() override {
        if (context_ == EGL_NO_CONTEXT) return;
        release(); // EGL does not destroy a context while it is current
        egl_.DestroyContext(display_, context_);
        context_ = EGL_NO_CONTEXT;
    }
    Gl::Loader loader() const override {
        return [this](const char* name) { return egl_.GetProcAddress(name); };
    }
    std::string description() const override { return description_; }

private:
    const Egl& egl_;
    EGLDisplay display_;
    EGLContext context_;
    std::string description_;
};

EGLConfig choose_config(const Egl& egl, EGLDisplay display) {
    const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                                       EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (egl.ChooseConfig(display, wanted.data(), &config, 1, &count) != EGL_TRUE || count == 0)
        throw ciel::Error("the display offers no OpenGL configuration");
    return config;
}

EGLContext create_context(const Egl& egl, EGLDisplay display, EGLConfig config) {
    std::vector<EGLint> attributes{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    // A driver that cannot report GPU resets creates no context with these attributes; then they are left out.
    std::vector<EGLint> robust{EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE,
                               EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET};
    robust.insert(robust.end(), attributes.begin(), attributes.end());
    EGLContext context = egl.CreateContext(display, config, EGL_NO_CONTEXT, robust.data());
    if (context == EGL_NO_CONTEXT) context = egl.CreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
    if (context == EGL_NO_CONTEXT)
        throw ciel::Error("the display cannot create an OpenGL 3.3 core context (" + egl.last_error() + ")");
    return context;
}

} // namespace

Egl::Egl()
    : library("libEGL.so.1"), GetProcAddress(library.get<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress")),
      QueryString(library.get<PFNEGLQUERYSTRINGPROC>("eglQueryString")),
      GetError(library.get<PFNEGLGETERRORPROC>("eglGetError")),
      Initialize(library.get<PFNEGLINITIALIZEPROC>("eglInitialize")),
      BindAPI(library.get<PFNEGLBINDAPIPROC>("eglBindAPI")),
      ChooseConfig(library.get<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig")),
      CreateContext(library.get<PFNEGLCREATECONTEXTPROC>("eglCreateContext")),
      DestroyContext(library.get<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext")),
      MakeCurrent(library.get<PFNEGLMAKECURRENTPROC>("eglMakeCurrent")),
      GetPlatformDisplay(
          reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(GetProcAddress("eglGetPlatformDisplayEXT"))) {
    if (GetPlatformDisplay == nullptr) throw ciel::Error("libEGL.so.1 lacks EGL_EXT_platform_base");
}

const Egl& Egl::instance() {
    static const Egl egl;
    return egl;
}

bool Egl::has_client_extension(std::string_view name) const {
    return has_word(QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), name);
}

std::string Egl::last_error() const {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "EGL error 0x%04x", static_cast<unsigned>(GetError()));
    return text.data();
}

bool has_word(const char* words, std::string_view word) {
    if (words == nullptr) return false;
    std::istringstream list(words);
    return std::find(std::istream_iterator<std::string>(list), {}, word) != std::istream_iterator<std::string>();
}

std::unique_ptr<GlContext> make_egl_context(const Egl& egl, EGLDisplay display, std::string description) {
    if (display == EGL_NO_DISPLAY) throw ciel::Error("EGL returned no display (" + egl.last_error() + ")");
    EGLint major = 0;
    EGLint minor = 0;
    if (egl.Initialize(display, &major, &minor) != EGL_TRUE)
        throw ciel::Error("the display cannot be initialized (" + egl.last_error() + ")");
    if (!has_word(egl.QueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
        throw ciel::Error("the display lacks EGL_KHR_surfaceless_context");
    if (egl.BindAPI(EGL_OPENGL_API) != EGL_TRUE) throw ciel::Error("the display has no desktop OpenGL");
    const EGLContext context = create_context(egl, display, choose_config(egl, display));
    auto made = std::make_unique<EglContext>(egl, display, context, std::move(description));
    if (!make_current(*made))
        throw ciel::Error("EGL cannot make its OpenGL context current (" + egl.last_error() + ")");
    return made;
}

} // namespace server::render
