// Computes contour lines of point values on a surface, such as a slice. Not in the paper.
#pragma once

#include "ciel/extract.hpp"
#include "ciel/values_view.hpp"

namespace ciel {

// Returns line segments, each as two positions (offsets from the mesh's surface_origin). The segments are in the order
// of `at`, and for each value of `at` in the order of the polygons. `values`: one for each point of the surface. Throws
// Error when `values` has another size. Uses all threads of parallel_for.
// Values are interpolated along the sides of the polygons, not along the edges of a triangulation. Therefore the lines
// of two adjacent polygons meet at their common side to the last bit. A point is high when its value >= the value of
// the line. Each run of successive high points of a polygon gets one segment. A polygon with a value that is not finite
// has no lines. A NaN in `at` gives no lines.
[[nodiscard]] std::vector<Vec3f> contour_lines(const Surface& surface, ValuesView values, std::span<const double> at);

} // namespace ciel
