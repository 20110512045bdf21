// Finds the boundary triangles that intersect each slab of a volume.
#pragma once

#include "render/frame/volume.hpp"

namespace server::render {

// Returns a list of triangles (three indices each) for each drawn slab, which consists of Volume::stride slabs. A
// triangle that crosses the border of two slabs is in both lists; the edge program (slab_shaders.hpp) decides in which
// slab a pixel is drawn.
[[nodiscard]] std::vector<std::vector<ciel::Index>> boundary_of_slabs(const Volume& volume);

} // namespace server::render
