// The boundary triangles of each slab of a volume.
#pragma once

#include "render/frame/volume.hpp"

namespace ciel::render {

// Returns, for each slab of `stride` slices, the triangles of volume.boundary that intersect it, three indices each.
// A triangle on the border of two slabs is in both lists: the edge program decides per pixel in which slab it draws.
[[nodiscard]] std::vector<std::vector<Index>> boundary_of_slabs(const Volume& volume);

} // namespace ciel::render
