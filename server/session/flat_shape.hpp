// Values of cells on a surface, as they are: every polygon has that of its cell, and none is mixed with its
// neighbours'.
#pragma once

#include "session/scene_geometry.hpp"

namespace ciel::session {

// The same polygons, no two of which have a common vertex.
[[nodiscard]] std::shared_ptr<const Shape> separated(const Shape& shape);

// For each of its vertices the value of the cell that its polygon belongs to. Throws Error where a cell has no value.
[[nodiscard]] std::vector<float> flat_values(const Surface& separated, std::span<const float> cell_values);

} // namespace ciel::session
