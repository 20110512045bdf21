// Algorithm 4, run once for every combination of high and low corners of a standard cell.
#pragma once

#include "ciel/standard_shapes.hpp"

#include <vector>

namespace ciel {

// The polygons for one combination of high corners, concatenated as edges of the shape. Each active edge is in exactly
// one polygon.
struct StandardCase {
    std::uint8_t polygons = 0, edges = 0;
    std::uint8_t ambiguous = 0;        // one bit per face, set if it is ambiguous
    std::array<std::uint8_t, 4> end{}; // end of each polygon in `edge`
    std::array<std::uint8_t, 12> edge{};
};

// Returns the cases of a shape. The index has one bit per corner, set if the corner is high. Each run of high corners
// of a face is cut off by itself. Seen from the high side, polygons run counter-clockwise.
template <const StandardShape& shape>
[[nodiscard]] const std::vector<StandardCase>& standard_cases();

// Returns the case in which the faces in `joined` (one bit per face) join their high corners. On these faces a polygon
// leaves at the active edge before the one where it enters.
[[nodiscard]] StandardCase joined_case(const StandardShape& shape, Index high, Index joined);

} // namespace ciel
