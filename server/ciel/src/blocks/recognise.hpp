// Recognizes a standard cell from its faces. Such a cell does not store the half-edge members (paper, section 2.2) that
// are the same for all cells of its type.
#pragma once

#include "blocks/block_loops.hpp"
#include "mesh/standard_shapes.hpp"

namespace ciel::detail {

struct StandardCell {
    std::array<Index, 8> corner{}; // local vertex of each corner of the shape
    std::array<LoopRef, 6> loop{}; // loop of the cell for each face of the shape
    std::array<Index, 6> turn{};   // by face of the shape: corner of the loop that the face's first half-edge leaves
};

// Returns false when the cell has collapsed or does not match the shape; `out` is then unspecified.
template <const StandardShape& shape>
[[nodiscard]] bool recognise(const BlockLoops& loops, Index local_cell, StandardCell& out);

} // namespace ciel::detail
