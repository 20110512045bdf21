// Triangles of a polygon that no fan covers: corners are cut off one by one where nothing lies in the way.
// Not in the paper, which leaves polygons to OpenGL.
// Source: G. H. Meisters, Polygons have ears, American Mathematical Monthly 82 (1975).
#pragma once

#include "ciel/types.hpp"

#include <span>
#include <vector>

namespace ciel {

// `corners`: counter-clockwise, three or more. Appends their number less two triangles, wound alike, as places among
// the corners. A polygon without crossings is covered once. One that crosses itself gets as many triangles, some of
// them turned over or without area. The work is at most 512 steps per corner: what lies in the way is found in a grid,
// and where that has taken too many steps the rest is not looked at any more.
void clip_ears(std::span<const std::array<double, 2>> corners, std::vector<Index>& out);

} // namespace ciel
