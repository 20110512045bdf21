// A linked program whose uniforms are set by name. It is meant for uniforms that are set only a few times per frame.
#pragma once

#include "render/context/gl.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace server::render {

// Vertex shader for a triangle that covers the whole viewport. Draw three vertices without attributes.
extern const char* const cover_vertex;

using Stage = std::pair<GLenum, std::string>; // kind and source text of a shader
// Links a program from shaders. Throws Error with the compiler's or the linker's message.
[[nodiscard]] GLuint link_stages(const Gl& gl, const std::vector<Stage>& stages);

class ShaderProgram {
public:
    ShaderProgram() = default;
    ShaderProgram(const Gl& gl, GLuint id) : gl_(&gl), id_(id) {}

    void use() const { gl_->UseProgram(id_); }
    // set() sets a uniform of the program, which must be in use.
    void set(const char* name, int value) const { gl_->Uniform1i(at(name), value); }
    void set(const char* name, float value) const { gl_->Uniform1f(at(name), value); }
    void set(const char* name, glm::vec2 value) const { gl_->Uniform2f(at(name), value.x, value.y); }
    void set(const char* name, glm::vec3 value) const { gl_->Uniform3f(at(name), value.x, value.y, value.z); }
    void set(const char* name, glm::vec4 value) const { gl_->Uniform4f(at(name), value.x, value.y, value.z, value.w); }
    void set(const char* name, std::span<const glm::vec4> values) const {
        gl_->Uniform4fv(at(name), static_cast<GLsizei>(values.size()), &values[0][0]);
    }
    void set(const char* name, const glm::mat4& value) const {
        gl_->UniformMatrix4fv(at(name), 1, GL_FALSE, &value[0][0]);
    }

private:
    [[nodiscard]] GLint at(const char* name) const { return gl_->GetUniformLocation(id_, name); }

    const Gl* gl_ = nullptr;
    GLuint id_ = 0;
};

// The make functions throw Error with the compiler's or the linker's message.
[[nodiscard]] ShaderProgram make_shader_program(const Gl& gl, const std::string& vertex, const std::string& fragment);
// The program runs `fragment` for every pixel of the viewport. Draw three vertices without attributes.
[[nodiscard]] ShaderProgram make_cover_program(const Gl& gl, const std::string& fragment);

} // namespace server::render
