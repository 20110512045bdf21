// Creates contexts with EGL on Mesa's surfaceless platform (EGL_MESA_platform_surfaceless).
#include "ciel/types.hpp"
#include "render/context/egl.hpp"

namespace server::render {

std::unique_ptr<GlContext> make_egl_surfaceless_context() {
    const Egl& egl = Egl::instance();
    if (!egl.has_client_extension("EGL_MESA_platform_surfaceless"))
        throw ciel::Error("EGL lacks EGL_MESA_platform_surfaceless");
    return make_egl_context(egl, egl.GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr), "Mesa");
}

} // namespace server::render
