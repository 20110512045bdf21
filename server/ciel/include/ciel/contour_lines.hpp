// Computes contour lines of point values on a surface, such as a slice. Not in the paper.
#pragma once

#include "ciel/extract.hpp"
#include "ciel/values_view.hpp"

namespace ciel {

// Returns line segments of two positions each (offsets from the mesh's surface_origin), for each value of `at` in turn,
// in the order of the polygons. `values`: one per point of the surface; throws Error on another number. Values are
// interpolated along the sides of the polygons, not along the edges of a triangulation. So lines of two polygons meet
// on their common side to the last bit. A point is high when its value >= the line's value. A polygon whose loop has
// several runs of high points gets one segment per run. A polygon with a value that is not finite has no lines. A NaN
// in `at` gives no lines.
[[nodiscard]] std::vector<Vec3f> contour_lines(const Surface& surface, ValuesView values, std::span<const double> at);

} // namespace ciel
