// The values of an array on the polygons of a surface, in the array's type.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace server::geometry {

// Returns the same polygons without shared vertices, so that every polygon can have the value of its cell or face.
[[nodiscard]] std::shared_ptr<const Shape> separated(const Shape& shape);

// Returns one value per vertex: the value of the polygon that has the vertex. `of_polygons`: one value per polygon.
[[nodiscard]] store::Values flat_values(const ciel::Surface& separated, ciel::ValuesView of_polygons);

} // namespace server::geometry
