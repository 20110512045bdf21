// Block tables: the data of all blocks that is needed before any record is read, as bytes (not in the paper).
#pragma once

#include "blocks/block_records.hpp"

namespace ciel::detail {

// Returns a record of the kind "tabl". Section 1 has the members of TopologyCounts (u64). Sections 2 to 5 have one
// number per block and one more at the end (u64). 2: first cell; 3: first owned vertex; 4: first owned edge; 5: sum of
// the vertex counts of all earlier blocks. Sections 6 and 7 have one number per block (u32). 6: number of half-edges;
// 7: number of border vertices.
[[nodiscard]] RecordBytes tables_of(const BlockNumbers& numbers, const TopologyCounts& counts);
// Throws Error when the tables contradict each other or a number needs more than 32 bits.
void read_tables(std::span<const std::byte> bytes, BlockNumbers& numbers, TopologyCounts& counts);

} // namespace ciel::detail
