// Sorts the triangles of a volume's slices into outer and inner ones. Inner triangles are far from the mesh's boundary:
// every ray through them is inside the mesh over their whole slab. Their program does not look up entries and exits.
#pragma once

#include "render/frame/volume.hpp"

namespace ciel::render {

// The triangles of a slice, the inner ones last. Large triangles near the boundary are split, so that most of their
// area is inner.
struct SortedSlice {
    const SlabMesh* slice = nullptr; // borrowed; has the first vertices
    std::vector<SlabVertex> more;    // vertices from splits, after those of the slice
    std::vector<Index> triangles;
    std::size_t outer = 0; // number of indices in `triangles` before the first inner triangle
};

// Tangent of the widest angle between a ray and the volume's normal for which inner triangles are valid.
// Slabs across a box axis use the axis nearest to the view, so wider rays occur only in close views.
inline constexpr double widest_inner = 3;

// Returns the sorted middle slice of each slab of `stride` slices; an empty one where the volume has no such slice.
// `boundary_of_slab`: the result of boundary_of_slabs(). Borrows the volume's slices.
[[nodiscard]] std::vector<SortedSlice> sort_slices(const Volume& volume,
                                                   std::span<const std::vector<Index>> boundary_of_slab);

} // namespace ciel::render
