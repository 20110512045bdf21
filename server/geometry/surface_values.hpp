// The values of an array on the polygons of a surface, in the array's type.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

// Returns the same polygons without shared vertices: then every polygon can have the value of its cell or face.
[[nodiscard]] std::shared_ptr<const Shape> separated(const Shape& shape);

// Returns per vertex the value of its polygon's item; store::no_value if the item is `none`. `items`: one per polygon.
// Throws Error if an item is not in `values`.
[[nodiscard]] store::Values flat_values(const Surface& separated, std::span<const Index> items, ValuesView values);

} // namespace ciel::geometry
