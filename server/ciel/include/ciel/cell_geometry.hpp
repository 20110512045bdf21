// Centres and areas of faces, centroids of cells. Not in the paper.
#pragma once

#include "ciel/face_mesh.hpp"

#include <vector>

namespace ciel {

[[nodiscard]] inline Vec3d position(const FaceMeshView& mesh, Index vertex) {
    const float* p = &mesh.positions[3 * std::size_t{vertex}];
    return {p[0], p[1], p[2]};
}

// Copies a face's loop; reads each index once. Throws Error when an index leads out of the mesh, as do read_cells,
// face_shapes and cell_centres.
// A mesh may be mapped from a file that changes after it was verified.
void read_loop(const FaceMeshView& mesh, Index face, std::vector<Index>& loop);

struct FaceCells {
    Index owner, neighbour; // neighbour may be `none`
};
[[nodiscard]] FaceCells read_cells(const FaceMeshView& mesh, Index face);

struct FaceShape {
    Vec3d centre{}; // as an offset from the mesh's origin
    Vec3d area{};   // along the normal, out of the owner
};

// Shape of a face with this loop. The indices must have been checked.
[[nodiscard]] FaceShape face_shape(const FaceMeshView& mesh, std::span<const Index> loop);
[[nodiscard]] std::vector<FaceShape> face_shapes(const FaceMeshView& mesh);

// Centroids of the cells, as offsets from the mesh's origin.
[[nodiscard]] std::vector<Vec3d> cell_centres(const FaceMeshView& mesh, const std::vector<FaceShape>& faces);

} // namespace ciel
