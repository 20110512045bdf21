// The EGL library, and creation of contexts without a surface. Both EGL back ends use them.
#pragma once

#include "render/context/gl_context.hpp"
#include "render/context/library.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <string_view>

namespace server::render {

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

// `words`: extension names separated by spaces, or null.
[[nodiscard]] bool has_word(const char* words, std::string_view word);

// Creates an OpenGL 3.3 core context on the display and makes it current. Throws Error if that fails.
// The display is never terminated. Displays are shared, and terminating a display would destroy all contexts on it.
[[nodiscard]] std::unique_ptr<GlContext> make_egl_context(const Egl& egl, EGLDisplay display, std::string description);

} // namespace server::render
