// The programs that draw a volume. Uniforms are set by name: a dozen a frame.
#pragma once

#include "render/gl.hpp"

#include <compare>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ciel::render {

enum VolumeAttribute : GLuint {
    volume_position = 0,
    volume_value = 1,
    volume_gradient = 2,
    volume_limits = 3,
};

// A ray is in the mesh in so many parts at most, from the eye on; slices after the last of them are drawn as if the
// mesh went on there.
inline constexpr int most_ray_parts = 4;

class VolumeProgram {
public:
    VolumeProgram() = default;
    VolumeProgram(const Gl& gl, GLuint id) : gl_(&gl), id_(id) {}

    void use() const { gl_->UseProgram(id_); }
    // Of the program in use.
    void set(const char* name, int value) const { gl_->Uniform1i(at(name), value); }
    void set(const char* name, float value) const { gl_->Uniform1f(at(name), value); }
    void set(const char* name, glm::vec2 value) const { gl_->Uniform2f(at(name), value.x, value.y); }
    void set(const char* name, glm::vec3 value) const { gl_->Uniform3f(at(name), value.x, value.y, value.z); }
    void set(const char* name, const glm::mat4& value) const {
        gl_->UniformMatrix4fv(at(name), 1, GL_FALSE, &value[0][0]);
    }

private:
    [[nodiscard]] GLint at(const char* name) const { return gl_->GetUniformLocation(id_, name); }

    const Gl* gl_ = nullptr;
    GLuint id_ = 0;
};

// Distances along a ray are depths: lengths along the view's axis.
//
// parts: where a ray enters (R) and leaves (G) the mesh; the first time, or next after the part in `before`.
[[nodiscard]] VolumeProgram make_part_program(const Gl& gl, bool first);
// First part, how far opaque surfaces let one see (B), and the window's depth of the entry (A).
[[nodiscard]] VolumeProgram make_limits_program(const Gl& gl);
// Slices: each for what a ray has in common with its slab; and boundary faces: for what no slice stands for.
struct SlabProgramKind {
    int parts = 1; // of a ray
    bool shaded = false;
    int table_rows = 1;
    auto operator<=>(const SlabProgramKind&) const = default; // NOLINT(modernize-use-nullptr): takes <=> for a 0
};
[[nodiscard]] VolumeProgram make_slice_program(const Gl& gl, const SlabProgramKind& kind);
[[nodiscard]] VolumeProgram make_edge_program(const Gl& gl, const SlabProgramKind& kind);
// The finished volume onto the picture.
[[nodiscard]] VolumeProgram make_volume_picture_program(const Gl& gl);

} // namespace ciel::render
