// GL buffers of one Primitives. They are kept from frame to frame.
#pragma once

#include "render/context/gl.hpp"
#include "render/frame/frame.hpp"
#include "render/surfaces/color_scales.hpp"

#include <vector>

namespace server::render {

// Throws Error if sizes do not match or an index is too large: the GL would read past the ends of the arrays.
void check_primitives(const Primitives& primitives);

class PrimitiveBuffers {
public:
    explicit PrimitiveBuffers(const Gl& gl);
    // Uploads the arrays if the revision is 0, or if identity or revision has changed since the last load(). Throws the
    // errors of check_primitives(). If cancelling (pacing.hpp) interrupts an upload, call load() again before draw().
    void load(const Primitives& primitives);
    // `primitives`: those of load(). Their color, point size, scale and lighting may have changed since then.
    void draw(const Primitives& primitives, const ScaleRow& scale) const;
    // Returns Primitives::identity of the loaded primitives; 0 before the first load().
    [[nodiscard]] std::uint64_t identity() const { return identity_; }

private:
    void upload(GLuint buffer, GLenum target, std::size_t bytes, const void* data);
    void attribute(GLuint index, GLuint buffer, int components, std::size_t bytes, const void* data);

    const Gl& gl_;
    GLuint array_ = 0, positions_ = 0, normals_ = 0, scalars_ = 0, indices_ = 0;
    std::uint64_t identity_ = 0, revision_ = 0;
    GLenum primitive_ = GL_TRIANGLES;
    std::size_t count_ = 0;
};

} // namespace server::render
