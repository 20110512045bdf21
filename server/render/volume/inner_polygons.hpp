// Which triangles of a volume's slices are so far from the mesh's boundary that every ray through them passes their
// whole slab inside the mesh: these are drawn by a program that need not ask where a ray enters and leaves it.
#pragma once

#include "render/frame/volume.hpp"

namespace ciel::render {

// The triangles of a slice, the inner ones last. Large ones that are near the boundary with a part of them only are
// split, so that most of their area is inner.
struct SortedSlice {
    const SlabMesh* slice = nullptr; // whose vertices they have; borrowed
    std::vector<SlabVertex> more;    // and after these
    std::vector<Index> triangles;
    std::size_t outer = 0; // how many entries before the first inner one
};

// Rays at a wider angle to the volume's normal than this, by its tangent, may meet the boundary in an inner triangle's
// slab all the same: those across an axis of a box are the nearest to the view, so there are none but close by.
inline constexpr double widest_inner = 3;

// Of each slab, of `stride` slices: of the slice in its middle; nothing where the volume has none there.
// `boundary_of_slab`: of boundary_of_slabs.
[[nodiscard]] std::vector<SortedSlice> sort_slices(const Volume& volume,
                                                   std::span<const std::vector<Index>> boundary_of_slab);

} // namespace ciel::render
