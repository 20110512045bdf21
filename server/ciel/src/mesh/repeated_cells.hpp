// Cells that a mesh lists more than once. Their faces would be matched with each other, or claimed by three cells.
// Algorithm 5 (paper, appendix A) does not expect this.
#pragma once

#include "ciel/assemble.hpp"

namespace ciel {

// Returns, ascending, the cells among `suspects` (ascending) that have the faces of an earlier suspect, in any winding
// and with any first corner. Ignores faces that collapsed to a line or a point. A cell that has a face twice repeats no
// cell: it collapsed to that face, like a row of cells at the pole of a curvilinear grid. O(n log n) in the corners.
[[nodiscard]] std::vector<Index> repeated_cells(const PolyhedraView& input, std::span<const Index> suspects);

} // namespace ciel
