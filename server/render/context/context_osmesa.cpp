// Creates contexts with OSMesa, Mesa's software renderer without EGL.
#include "ciel/types.hpp"
#include "render/context/gl_context.hpp"
#include "render/context/library.hpp"

#include <GL/osmesa.h>
#include <array>
#include <cstdint>

namespace server::render {
namespace {

struct OsMesa {
    Library library{"libOSMesa.so.8"};
    decltype(&OSMesaCreateContextAttribs) CreateContextAttribs =
        library.get<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
    decltype(&OSMesaDestroyContext) DestroyContext =
        library.get<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext");
    decltype(&OSMesaMakeCurrent) MakeCurrent = library.get<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    decltype(&OSMesaGetProcAddress) GetProcAddress =
        library.get<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress");

    static const OsMesa& instance() {
        static const OsMesa library;
        return library;
    }
};

class OsMesaContext final : public GlContext {
public:
    OsMesaContext(const OsMesa& library, OSMesaContext context) : library_(library), context_(context) {}
    ~OsMesaContext() override {
        forget_current(*this);
        lose();
    }

    bool make_current() override {
        return context_ != nullptr && library_.MakeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE;
    }
    void release() override { library_.MakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }
    void lose() override {
        if (context_ == nullptr) return;
        release();
        library_.DestroyContext(context_);
        context_ = nullptr;
    }
    Gl::Loader loader() const override {
        return [this](const char* name) { return library_.GetProcAddress(name); };
    }
    std::string description() const override { return "software"; }

private:
    const OsMesa& library_;
    OSMesaContext context_;
    std::array<std::uint8_t, 4> pixel_{}; // OSMesa requires a default framebuffer; nothing is drawn to it
};

} // namespace

std::unique_ptr<GlContext> make_osmesa_context() {
    const OsMesa& library = OsMesa::instance();
    const std::array<int, 13> attributes{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_DEPTH_BITS,
                                         0,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         3,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         3,
                                         0};
    OSMesaContext context = library.CreateContextAttribs(attributes.data(), nullptr);
    if (context == nullptr) throw ciel::Error("OSMesa cannot create an OpenGL 3.3 core context");
    auto made = std::make_unique<OsMesaContext>(library, context);
    if (!make_current(*made)) throw ciel::Error("OSMesa cannot make its OpenGL context current");
    return made;
}

} // namespace server::render
