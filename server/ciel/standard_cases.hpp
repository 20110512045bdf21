// Algorithm 4 run once for each way in which the corners of a standard cell can be high or low.
#pragma once

#include "ciel/standard_shapes.hpp"

#include <vector>

namespace ciel {

// Polygons as edges of the shape, one after another; an active edge is in exactly one of them.
struct StandardCase {
    std::uint8_t polygons = 0, edges = 0;
    bool ambiguous = false;            // a face has more than one way to join its points
    std::array<std::uint8_t, 4> end{}; // of each polygon, in `edge`
    std::array<std::uint8_t, 12> edge{};
};

// By a bit per corner, set where it is high. The high side is cut off by itself on every face; seen from it, polygons
// run counter-clockwise.
template <const StandardShape& shape>
[[nodiscard]] const std::vector<StandardCase>& standard_cases();

} // namespace ciel
