// Ear clipping of polygons that no triangle fan covers. An ear is a corner whose triangle contains no other corner.
// Source: G. H. Meisters, Polygons have ears, American Mathematical Monthly 82 (1975). Not in the paper.
#pragma once

#include "ciel/types.hpp"

#include <span>
#include <vector>

namespace ciel::detail {

// Triangulates a polygon. `corners`: at least three, counter-clockwise. Appends corners.size() - 2 triangles to `out`,
// as indices in `corners`, with the winding of the polygon. If the polygon does not cross itself, the triangles cover
// it exactly once. If it crosses itself, some triangles are reversed or have no area. The search for ears uses a grid
// of the corners. Each visit of a grid cell or of a corner is a step. After 512 * corners.size() steps, the remaining
// corners are cut off without a test.
void clip_ears(std::span<const std::array<double, 2>> corners, std::vector<Index>& out);

} // namespace ciel::detail
