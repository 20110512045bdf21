// Values of cells or of faces on a surface. Every polygon has the value of its cell or face; nothing is interpolated.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

// Returns the same polygons without shared vertices.
[[nodiscard]] std::shared_ptr<const Shape> separated(const Shape& shape);

// Returns per vertex the value of its polygon's item; store::no_value if the item is `none`. `items`: one per polygon.
// Throws Error if an item is not in `values`.
[[nodiscard]] std::vector<float> flat_values(const Surface& separated, std::span<const Index> items,
                                             std::span<const float> values);

} // namespace ciel::geometry
