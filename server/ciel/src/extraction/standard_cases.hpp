// Algorithm 4, run once for every combination of high and low corners of a standard cell.
#pragma once

#include "ciel/standard_shapes.hpp"

#include <vector>

namespace ciel {

// Polygons as edges of the shape, one after another; an active edge is in exactly one of them.
struct StandardCase {
    std::uint8_t polygons = 0, edges = 0;
    std::uint8_t ambiguous = 0;        // one bit per ambiguous face
    std::array<std::uint8_t, 4> end{}; // of each polygon, in `edge`
    std::array<std::uint8_t, 12> edge{};
};

// Returns the cases, indexed by one bit per corner, set if it is high. On every face each high run is cut off by
// itself. Seen from the high side, polygons run counter-clockwise.
template <const StandardShape& shape>
[[nodiscard]] const std::vector<StandardCase>& standard_cases();

// Returns the case in which the faces in `joined` (one bit each) join their high corners. Such a face is left at the
// active edge before the entry.
[[nodiscard]] StandardCase joined_case(const StandardShape& shape, Index high, Index joined);

} // namespace ciel
