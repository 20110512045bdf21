// Contour lines of an array on a surface, such as a slice. Not in the paper.
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

// Returns segments of two positions each (offsets from the mesh's origin), value by value, in the order of the
// polygons. `values`: one per point of the surface; throws Error on another number.
// Values are interpolated along the polygons' own sides. So two polygons agree on their common side to the last bit,
// and no line bends at a triangulation.
// High means value >= nu. A polygon with several high runs gets one segment per run, as faces of cells do
// (extract.hpp). A polygon with a value that is not finite has no lines. A NaN in `at` gives no lines.
[[nodiscard]] std::vector<Vec3f> contour_lines(const Surface& surface, std::span<const float> values,
                                               std::span<const double> at);

} // namespace ciel
