// Where an array takes given values on a surface: the contour lines of a slice. Not in the paper.
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

// Segments, two positions each (offsets from the mesh's origin), value by value, in the order of the polygons.
// `values`: one per point of the surface; throws Error on another number. They are interpolated along the polygons'
// own sides, so two polygons agree on their side to the last bit, and no line bends at a triangulation. High means
// value >= nu, and a polygon with several high runs gets one segment each, as faces of cells do (extract.hpp). A
// polygon with a point without a finite value has no lines, nor has a value that is not a number.
[[nodiscard]] std::vector<Vec3f> contour_lines(const Surface& surface, std::span<const float> values,
                                               std::span<const double> at);

} // namespace ciel
