// Sorts the triangles of a volume's slices. Inner triangles are far from the mesh's boundary: a ray through one is
// inside the mesh over the whole slab, so their program does not look up entries and exits.
#pragma once

#include "render/frame/volume.hpp"

namespace server::render {

// Inner triangles are last. Large triangles near the boundary are split, so that most of their area is inner.
struct SortedSlice {
    const color::SlabMesh* slice = nullptr; // not owned; its vertices have the first indices
    std::vector<color::SlabVertex> more;    // vertices from splits; their indices follow the vertices of the slice
    std::vector<ciel::Index> triangles;
    std::size_t outer = 0; // number of indices in `triangles` before the first inner triangle
};

// Tangent of the largest angle between a ray and the volume's normal up to which inner triangles are valid. Slabs
// normal to a box axis use the axis nearest to the view direction. Therefore larger angles occur only in close views.
inline constexpr double widest_inner = 3;

// Returns the middle slice of each drawn slab, which consists of Volume::stride slabs; empty if there is no such slice.
// `boundary_of_slab`: result of boundary_of_slabs(). The volume's slices must outlive the result.
[[nodiscard]] std::vector<SortedSlice> sort_slices(const Volume& volume,
                                                   std::span<const std::vector<ciel::Index>> boundary_of_slab);

} // namespace server::render
