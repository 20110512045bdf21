#include "render/context/shader_program.hpp"

#include "ciel/types.hpp"

namespace server::render {
namespace {

void add_shader(const Gl& gl, GLuint program, GLenum kind, const std::string& source) {
    const GLuint shader = gl.CreateShader(kind);
    const char* text = source.c_str();
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    GLint is_compiled = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
    if (is_compiled == 0) {
        std::vector<char> log(4096);
        gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw ciel::Error("the GL driver cannot compile a shader; update the driver. Its message: " +
                          std::string(log.data()));
    }
    gl.AttachShader(program, shader);
}

} // namespace

const char* const cover_vertex = R"(#version 330 core
void main() {
    vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
)";

GLuint link_stages(const Gl& gl, const std::vector<Stage>& stages) {
    const GLuint program = gl.CreateProgram();
    for (const auto& [kind, source] : stages) add_shader(gl, program, kind, source);
    gl.LinkProgram(program);
    GLint is_linked = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &is_linked);
    if (is_linked == 0) {
        std::vector<char> log(4096);
        gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw ciel::Error("the GL driver cannot link a shader program; update the driver. Its message: " +
                          std::string(log.data()));
    }
    return program;
}

ShaderProgram make_shader_program(const Gl& gl, const std::string& vertex, const std::string& fragment) {
    return {gl, link_stages(gl, {{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}})};
}

ShaderProgram make_cover_program(const Gl& gl, const std::string& fragment) {
    return make_shader_program(gl, cover_vertex, fragment);
}

} // namespace server::render
