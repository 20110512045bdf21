// GL buffers of one mesh, kept from frame to frame.
#pragma once

#include "render/context/gl.hpp"
#include "render/frame/frame.hpp"
#include "render/surfaces/color_scales.hpp"

#include <vector>

namespace ciel::render {

// Throws Error when sizes or indices of the mesh's arrays do not match. The GL would read past the arrays' ends.
void check_primitives(const Primitives& mesh);

class PrimitiveBuffers {
public:
    explicit PrimitiveBuffers(const Gl& gl);
    // Uploads the mesh unless the buffers hold this identity and revision already; revision 0 is always uploaded.
    // Throws like check_primitives(). Cancelling (pacing.hpp) may interrupt an upload; then call load() again before
    // draw().
    void load(const Primitives& mesh);
    // `mesh`: the loaded mesh; color, point size and lighting may differ from those at load().
    void draw(const Primitives& mesh, const ScaleRow& scale) const;
    [[nodiscard]] std::uint64_t identity() const {
        return identity_;
    } // identity(): Primitives::identity of the loaded mesh; 0 before the first load()

private:
    void upload(GLuint buffer, GLenum target, std::size_t bytes, const void* data);
    void attribute(GLuint index, GLuint buffer, int components, std::size_t bytes, const void* data);

    const Gl& gl_;
    GLuint array_ = 0, positions_ = 0, normals_ = 0, scalars_ = 0, indices_ = 0;
    std::uint64_t identity_ = 0, revision_ = 0;
    GLenum primitive_ = GL_TRIANGLES;
    std::size_t count_ = 0;
};

} // namespace ciel::render
