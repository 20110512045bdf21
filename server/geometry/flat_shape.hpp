// Values of cells or of faces on a surface. Every polygon has the value of its cell or face; nothing is interpolated.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

// The same polygons, no two of which have a common vertex.
[[nodiscard]] std::shared_ptr<const Shape> separated(const Shape& shape);

// For each of its vertices the value of its polygon's item; `none` has store::no_value. `items`: one per polygon.
// Throws Error where an item has no value.
[[nodiscard]] std::vector<float> flat_values(const Surface& separated, std::span<const Index> items,
                                             std::span<const float> values);

} // namespace ciel::geometry
