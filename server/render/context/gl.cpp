#include "render/context/gl.hpp"

#include "ciel/types.hpp"

namespace server::render {

Gl Gl::load(const Loader& loader) {
    Gl gl;
#define CIEL_GL_LOAD(name, type)                                                                                       \
    gl.name = reinterpret_cast<type>(loader("gl" #name));                                                              \
    if (gl.name == nullptr) throw ciel::Error("the GL driver lacks gl" #name "; install a driver with OpenGL 3.3");
    CIEL_GL_FUNCTIONS(CIEL_GL_LOAD)
#undef CIEL_GL_LOAD
    for (const char* name :
         {"glGetGraphicsResetStatus", "glGetGraphicsResetStatusARB", "glGetGraphicsResetStatusKHR"}) {
        if (gl.GetGraphicsResetStatus == nullptr)
            gl.GetGraphicsResetStatus = reinterpret_cast<PFNGLGETGRAPHICSRESETSTATUSPROC>(loader(name));
    }
    return gl;
}

} // namespace server::render
