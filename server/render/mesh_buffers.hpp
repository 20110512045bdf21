// The vertex buffers of one mesh on the GL's side, used again from frame to frame.
#pragma once

#include "render/gl.hpp"
#include "render/renderer.hpp"

#include <vector>

namespace ciel::render {

// Scalar * a + b runs from 0 to 1 over the range; a range of no width sends everything to the middle colour.
[[nodiscard]] std::array<float, 2> normalisation(const std::array<float, 2>& range);
// Row in the texture of colour maps, or 255 for solid meshes.
[[nodiscard]] float color_map_row(const Mesh& mesh);
// Indices of one primitive.
[[nodiscard]] inline std::size_t corners_of(const Mesh& mesh) { return mesh.points ? 1 : mesh.lines ? 2 : 3; }
// Throws Error when the mesh's arrays do not fit together: the GL would read past their ends.
void check_mesh(const Mesh& mesh);

class MeshBuffers {
public:
    explicit MeshBuffers(const Gl& gl);
    // Uploads the mesh unless `may_keep` and the buffers hold this identity and revision already.
    void load(const Mesh& mesh, bool may_keep);
    void draw() const;

private:
    void upload(GLuint buffer, GLenum target, std::size_t bytes, const void* data);
    void attribute(GLuint index, GLuint buffer, int components, std::size_t bytes, const void* data);

    const Gl& gl_;
    GLuint array_ = 0, positions_ = 0, normals_ = 0, scalars_ = 0, indices_ = 0;
    std::uint64_t identity_ = 0, revision_ = 0;
    GLenum primitive_ = GL_TRIANGLES;
    GLsizei count_ = 0;
};

} // namespace ciel::render
