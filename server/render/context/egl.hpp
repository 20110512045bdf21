// The EGL library and surfaceless contexts, for both EGL back ends.
#pragma once

#include "render/context/gl_context.hpp"
#include "render/context/library.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <string_view>

namespace ciel::render {

struct Egl {
    Library library;
    PFNEGLGETPROCADDRESSPROC GetProcAddress;
    PFNEGLQUERYSTRINGPROC QueryString;
    PFNEGLGETERRORPROC GetError;
    PFNEGLINITIALIZEPROC Initialize;
    PFNEGLBINDAPIPROC BindAPI;
    PFNEGLCHOOSECONFIGPROC ChooseConfig;
    PFNEGLCREATECONTEXTPROC CreateContext;
    PFNEGLDESTROYCONTEXTPROC DestroyContext;
    PFNEGLMAKECURRENTPROC MakeCurrent;
    PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay;

    static const Egl& instance(); // opens the library once; throws Error when it is missing
    [[nodiscard]] bool has_client_extension(std::string_view name) const;
    [[nodiscard]] std::string last_error() const; // for example "EGL error 0x3001"

private:
    Egl();
};

[[nodiscard]] bool has_word(const char* words, std::string_view word); // `words`: an extension string or null

// Creates an OpenGL 3.3 core context on the display. Throws Error when that fails.
// The display is never terminated: displays are shared, and terminating one would end every context on it.
[[nodiscard]] std::unique_ptr<GlContext> make_egl_context(const Egl& egl, EGLDisplay display, std::string description);

} // namespace ciel::render
