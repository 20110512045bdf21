// Finds cells that a mesh lists more than once. Algorithm 5 (paper, appendix A) does not handle repeated cells.
#pragma once

#include "mesh/input_faces.hpp"

namespace ciel::detail {

// Returns the cells of `suspects` that have the same faces as an earlier suspect, in any winding and with any first
// corner. `suspects` and the result are ascending. Ignores collapsed faces. Never returns a cell that has a face twice;
// such a cell has collapsed, as at the pole of a curvilinear grid. Takes O(n log n) in the number of corners.
[[nodiscard]] std::vector<Index> repeated_cells(const InputFaces& input, std::span<const Index> suspects);

} // namespace ciel::detail
