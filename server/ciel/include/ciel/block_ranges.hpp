// [min, max] of a field in each block of a topology. With them a field is made without reading a block; a cut then
// touches the blocks whose range holds nu. Not in the paper, which keeps minima for the whole mesh (section 2.2).
#pragma once

#include "ciel/topology.hpp"
#include "ciel/values_view.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ciel {

// One entry per block, over all its vertices, including those that it shares with other blocks.
struct BlockRanges {
    std::vector<double> low, high;      // of the finite values; low > high if there are none
    std::vector<std::uint32_t> missing; // number of vertices with NaN or an infinity
};

// values: one per vertex, in the topology's order. Reads the cells of every block. Uses all threads of the parallel
// loop. Throws Error on another number of values.
[[nodiscard]] BlockRanges block_ranges(const Topology& topology, ValuesView values);

// The boxes around the vertices of each block: ranges of x, y and z.
using BlockBoxes = std::array<BlockRanges, 3>;

// positions: x, y, z of each vertex, in the topology's order. Otherwise like block_ranges.
[[nodiscard]] BlockBoxes block_boxes(const Topology& topology, ValuesView positions);

} // namespace ciel
