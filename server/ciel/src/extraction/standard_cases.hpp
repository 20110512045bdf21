// Results of Algorithm 4 for every combination of high and low corners of a standard cell.
#pragma once

#include "mesh/standard_shapes.hpp"

#include <vector>

namespace ciel::detail {

// A corner of a polygon is given as the edge of the shape on which it lies.
struct StandardCase {
    std::uint8_t polygons = 0, edges = 0;
    std::uint8_t ambiguous = 0;        // one bit for each face, set if the face is ambiguous
    std::array<std::uint8_t, 4> end{}; // end of each polygon in `edge`
    std::array<std::uint8_t, 12> edge{};
};

// Returns all cases of a shape. The index has one bit for each corner of the shape, set if the corner is high. On
// ambiguous faces, high corners are not joined. Seen from the high side, polygons run counter-clockwise.
template <const StandardShape& shape>
[[nodiscard]] const std::vector<StandardCase>& standard_cases();

// Returns one case. `high`: one bit for each high corner. `joined`: one bit for each face on which high corners are
// joined. On such a face, a polygon leaves at the active edge before its entry edge. On any other face, it leaves at
// the active edge after its entry edge.
[[nodiscard]] StandardCase joined_case(const StandardShape& shape, Index high, Index joined);

} // namespace ciel::detail
