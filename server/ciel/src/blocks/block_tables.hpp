// The tables of a mesh's blocks as bytes (not in the paper): what is known of every block before its records are read.
#pragma once

#include "blocks/block_records.hpp"

namespace ciel {

// A record of the kind "tabl". Sections: 1: the members of TopologyCounts (u64); by block and one more: 2: first
// cell, 3: first owned vertex, 4: first owned edge, 5: sum of the vertex counts of the blocks before (u64 each); by
// block: 6: half-edges, 7: border vertices (u32 each).
[[nodiscard]] RecordBytes tables_of(const BlockNumbers& numbers, const TopologyCounts& counts);
// Reads the result of tables_of. Throws Error when the tables contradict each other or a number needs more than 32
// bits.
void read_tables(std::span<const std::byte> bytes, BlockNumbers& numbers, TopologyCounts& counts);

} // namespace ciel
