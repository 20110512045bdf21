// Triangulates polygons that no fan covers: cuts off ears, corners whose triangle contains no other corner.
// Not in the paper, which leaves polygons to OpenGL.
// Source: G. H. Meisters, Polygons have ears, American Mathematical Monthly 82 (1975).
#pragma once

#include "ciel/types.hpp"

#include <span>
#include <vector>

namespace ciel {

// `corners`: counter-clockwise, at least three. Appends corners.size() - 2 triangles with the polygon's winding, as
// indices into `corners`. If the polygon does not cross itself, the triangles cover it exactly once. If it does, some
// triangles are reversed or have no area. Finds the corners inside an ear in a grid, to save steps. When
// 512 * corners.size() steps are used up, the remaining corners are cut off without a test.
void clip_ears(std::span<const std::array<double, 2>> corners, std::vector<Index>& out);

} // namespace ciel
