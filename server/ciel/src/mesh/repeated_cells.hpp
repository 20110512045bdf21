// Cells that a mesh lists more than once: the copies' faces would be matched with each other, or claimed by three
// cells. A case that Algorithm 5 (paper, appendix A) does not expect.
#pragma once

#include "ciel/assemble.hpp"

namespace ciel {

// The cells among `suspects` (ascending) that have the faces of an earlier one, whatever their windings and first
// corners; ascending. Faces that collapsed to a line or a point do not count, and a cell that has a face twice (it
// collapsed to that face: a curvilinear grid's pole has a row of them) repeats nothing. O(n log n) in their corners.
[[nodiscard]] std::vector<Index> repeated_cells(const PolyhedraView& input, std::span<const Index> suspects);

} // namespace ciel
