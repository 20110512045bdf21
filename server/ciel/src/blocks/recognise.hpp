// Finds the corners of a cell, in the order of its standard type, from its faces. Then the cell need not store the
// half-edge members (paper, section 2.2) that all cells of the type have in common. Any thread.
#pragma once

#include "blocks/block_loops.hpp"
#include "ciel/standard_shapes.hpp"

namespace ciel {

struct StandardCell {
    std::array<Index, 8> corner{}; // local vertex of each corner of the shape
    std::array<LoopRef, 6> loop{}; // loop of the cell for each face of the shape
    std::array<Index, 6> turn{};   // by face: corner of the loop that the face's first half-edge leaves
};

// Returns false when the cell has collapsed or its faces do not match those of the shape. `out` is then unspecified.
template <const StandardShape& shape>
[[nodiscard]] bool recognise(const BlockLoops& loops, Index local_cell, StandardCell& out);

} // namespace ciel
