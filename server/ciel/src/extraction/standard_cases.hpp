// Algorithm 4 run once for each way in which the corners of a standard cell can be high or low.
#pragma once

#include "ciel/standard_shapes.hpp"

#include <vector>

namespace ciel {

// Polygons as edges of the shape, one after another; an active edge is in exactly one of them.
struct StandardCase {
    std::uint8_t polygons = 0, edges = 0;
    std::uint8_t ambiguous = 0;        // a bit per face with more than one way to join its points
    std::array<std::uint8_t, 4> end{}; // of each polygon, in `edge`
    std::array<std::uint8_t, 12> edge{};
};

// By a bit per corner, set where it is high. The high side is cut off by itself on every face; seen from it, polygons
// run counter-clockwise.
template <const StandardShape& shape>
[[nodiscard]] const std::vector<StandardCase>& standard_cases();

// The same where some faces, a bit each, join their high corners instead: left at the active edge before the entry.
[[nodiscard]] StandardCase joined_case(const StandardShape& shape, Index high, Index joined);

} // namespace ciel
