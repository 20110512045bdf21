// The boundary triangles that intersect each slab of a volume.
#pragma once

#include "render/frame/volume.hpp"

namespace ciel::render {

// Returns one list for each drawn slab, which consists of Volume::stride slabs of the volume. The list has the
// triangles of volume.boundary that intersect the slab, three indices for each. A triangle on the border of two slabs
// is in both lists. The edge program (slab_shaders.hpp) decides for each pixel in which slab the triangle is drawn.
[[nodiscard]] std::vector<std::vector<Index>> boundary_of_slabs(const Volume& volume);

} // namespace ciel::render
