// Reads the vertices and cells of faces, and computes their centers and areas. Not in the paper. Any thread may call
// the functions. Before a call of a function that reads positions, the caller must load the positions
// (FaceMeshView::loader).
#pragma once

#include "ciel/face_mesh.hpp"

#include <vector>

namespace ciel {

// Returns the stored position of a vertex, which is an offset from mesh.origin.
[[nodiscard]] inline Vec3d position(const FaceMeshView& mesh, Index vertex) {
    const std::size_t at = 3 * std::size_t{vertex};
    return {mesh.positions[at], mesh.positions[at + 1], mesh.positions[at + 2]};
}

// Returns the position of a vertex as surfaces store it: a float offset from mesh.surface_origin.
[[nodiscard]] inline Vec3f surface_position(const FaceMeshView& mesh, Index vertex) {
    const Vec3d at = position(mesh, vertex), shift = mesh.surface_shift();
    return {static_cast<float>(at[0] + shift[0]), static_cast<float>(at[1] + shift[1]),
            static_cast<float>(at[2] + shift[2])};
}

// Sets `loop` to the vertex ids of a face. Reads each id only once, because another process may change an id in a
// mapped file between two reads. read_loop and read_cells throw Error when an index that they read is out of range.
// REQUIRES: the face exists.
void read_loop(const FaceMeshView& mesh, Index face, std::vector<Index>& loop);

struct FaceCells {
    Index owner, neighbour; // neighbour is `none` on the boundary
};
[[nodiscard]] FaceCells read_cells(const FaceMeshView& mesh, Index face);

struct FaceShape {
    Vec3d center{}; // offset from the mesh's origin
    Vec3d area{};   // normal of the face, pointing out of the owner; its length is the area
};

// Returns the shape of the face whose vertex ids are `loop`. REQUIRES: loop is not empty, and all ids are below
// mesh.vertex_count().
[[nodiscard]] FaceShape face_shape(const FaceMeshView& mesh, std::span<const Index> loop);

} // namespace ciel
