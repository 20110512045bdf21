// BlockRanges: [min, max] of a field in each block of a topology. With stored ranges, a field can be made without
// reading a block. An iso-surface reads only the blocks whose range contains the iso-value. Not in the paper, which has
// sorted minima for the whole mesh instead (section 2.2).
#pragma once

#include "ciel/topology.hpp"
#include "ciel/values_view.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ciel {

// Each array has one entry for each block. A range covers all vertices of the block, including vertices that other
// blocks share.
struct BlockRanges {
    std::vector<double> low, high;      // of the finite values; low > high if there are none
    std::vector<std::uint32_t> missing; // number of vertices whose value is NaN or infinite
};

// Returns the ranges of `values`, which has one value for each vertex, in the topology's vertex order. Reads the cell
// records of all blocks. Uses all threads of parallel_for. Throws Error when `values` has another size.
[[nodiscard]] BlockRanges block_ranges(const Topology& topology, ValuesView values);

// Bounding boxes of the vertices of each block: the ranges of x, y and z.
using BlockBoxes = std::array<BlockRanges, 3>;

// Returns the boxes of `positions`: x, y, z of each vertex, in the topology's vertex order. Reads the cell records of
// all blocks. Uses all threads of parallel_for. Throws Error when `positions` has another size.
[[nodiscard]] BlockBoxes block_boxes(const Topology& topology, ValuesView positions);

} // namespace ciel
