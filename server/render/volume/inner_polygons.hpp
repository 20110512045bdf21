// Sorts the triangles of a volume's slices into inner and outer ones. Inner triangles are far from the mesh's boundary:
// a ray through an inner triangle is inside the mesh over the whole slab. Therefore the program for inner triangles
// does not look up where rays enter and leave the mesh.
#pragma once

#include "render/frame/volume.hpp"

namespace server::render {

// Inner triangles are last. Large triangles near the boundary are split, so that most of their area is inner.
struct SortedSlice {
    const color::SlabTriangles* slice = nullptr; // not owned; its vertices have the first indices
    std::vector<color::SlabVertex> more;         // vertices from splits; their indices follow the vertices of the slice
    std::vector<ciel::Index> triangles;
    std::size_t outer = 0; // number of indices in `triangles` before the first inner triangle
};

// Tangent of the largest angle between a ray and the volume's normal up to which inner triangles are valid. Larger
// angles occur only in close views, or if the scene requests slabs across an axis that is far from the view direction.
inline constexpr double widest_inner = 3;

// Returns the middle slice of each drawn slab, which consists of Volume::stride slabs; empty if there is no such slice.
// `boundary_of_slab`: result of boundary_of_slabs(). The volume's slices must outlive the result.
[[nodiscard]] std::vector<SortedSlice> sort_slices(const Volume& volume,
                                                   std::span<const std::vector<ciel::Index>> boundary_of_slab);

} // namespace server::render
