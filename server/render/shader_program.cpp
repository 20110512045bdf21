#include "render/shader_program.hpp"

#include "render/shaders.hpp"

namespace ciel::render {

ShaderProgram make_shader_program(const Gl& gl, const std::string& vertex, const std::string& fragment) {
    return {gl, link_stages(gl, {{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}})};
}

ShaderProgram make_cover_program(const Gl& gl, const std::string& fragment) {
    return make_shader_program(gl, cover_vertex, fragment);
}

} // namespace ciel::render
