// Computes centers and areas of faces, and centroids of cells. Not in the paper.
#pragma once

#include "ciel/face_mesh.hpp"

#include <vector>

namespace ciel {

// Returns the stored position, which is relative to the mesh's origin.
[[nodiscard]] inline Vec3d position(const FaceMeshView& mesh, Index vertex) {
    const std::size_t at = 3 * std::size_t{vertex};
    return {mesh.positions[at], mesh.positions[at + 1], mesh.positions[at + 2]};
}

// Returns the position relative to surface_origin, as surfaces have it.
[[nodiscard]] inline Vec3f surface_position(const FaceMeshView& mesh, Index vertex) {
    const Vec3d at = position(mesh, vertex), shift = mesh.surface_shift();
    return {static_cast<float>(at[0] + shift[0]), static_cast<float>(at[1] + shift[1]),
            static_cast<float>(at[2] + shift[2])};
}

// Copies the vertex ids of a face into `loop` and reads each id once, because another process may change a mapped file
// at any time. Like read_cells, face_shapes and cell_centres, throws Error when an index is out of range.
void read_loop(const FaceMeshView& mesh, Index face, std::vector<Index>& loop);

struct FaceCells {
    Index owner, neighbour; // neighbour may be `none`
};
[[nodiscard]] FaceCells read_cells(const FaceMeshView& mesh, Index face);

struct FaceShape {
    Vec3d centre{}; // as an offset from the mesh's origin
    Vec3d area{};   // vector along the normal, out of the owner; its length is the area
};

// Returns the shape of the face with these vertex ids. REQUIRES: all ids are below mesh.vertex_count().
[[nodiscard]] FaceShape face_shape(const FaceMeshView& mesh, std::span<const Index> loop);
[[nodiscard]] std::vector<FaceShape> face_shapes(const FaceMeshView& mesh);

// Returns the centroids of all cells, as offsets from the mesh's origin. `faces` is the result of face_shapes.
[[nodiscard]] std::vector<Vec3d> cell_centres(const FaceMeshView& mesh, const std::vector<FaceShape>& faces);

} // namespace ciel
