// Which part of a volume's boundary lies in which slab.
#pragma once

#include "render/frame/volume.hpp"

namespace ciel::render {

// Of each slab, of `stride` slices: the triangles of volume.boundary that it has a part of, three entries each. One on
// the border of two slabs is in both lists: the program that draws them decides pixel by pixel.
[[nodiscard]] std::vector<std::vector<Index>> boundary_of_slabs(const Volume& volume);

} // namespace ciel::render
