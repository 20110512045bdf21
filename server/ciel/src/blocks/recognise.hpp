// Finds a cell's corners, in the order of its standard type, from its faces, so that what the paper stores with each
// half-edge (section 2.2) is the type's. Any thread.
#pragma once

#include "blocks/block_loops.hpp"
#include "ciel/standard_shapes.hpp"

namespace ciel {

struct StandardCell {
    std::array<Index, 8> corner{}; // local vertices
    std::array<LoopRef, 6> loop{}; // by face of the shape
    std::array<Index, 6> turn{};   // which corner of that loop the face's first half-edge leaves
};

// False for a cell that is not quite of the type: collapsed, or with faces that do not fit.
template <const StandardShape& shape>
[[nodiscard]] bool recognise(const BlockLoops& loops, Index local_cell, StandardCell& out);

} // namespace ciel
