// Writes the three records of a block, and views them (not in the paper). A record has no pointer and no mesh-wide
// number. It refers to another block by an index into its list of neighbors; the list has differences between block
// numbers. Local ids of cells, vertices and edges have the order of the mesh-wide ids.
#pragma once

#include "blocks/block_around.hpp"
#include "blocks/block_mates.hpp"
#include "blocks/record.hpp"

namespace ciel::detail {

// The first four lists have one entry per block, and at the end the first unused id.
struct BlockNumbers {
    std::vector<Index> cell, vertex, edge; // first cell, first owned vertex and first owned edge of each block
    std::vector<Index> slot;               // sum of vertex_count of all earlier blocks (Block::vertex_begin)
    // By block. Links from other blocks are checked against these numbers.
    std::vector<Index> half_edges, border_vertices;

    [[nodiscard]] std::size_t block_count() const { return cell.empty() ? 0 : cell.size() - 1; }
};

[[nodiscard]] RecordBytes record_of(const BlockOf<Owned>& block, Index number, const BlockNumbers& numbers);
[[nodiscard]] RecordBytes record_of(const BlockOf<Owned>& block, const BlockAroundOf<Owned>& around, Index number);
[[nodiscard]] RecordBytes record_of(const BlockOf<Owned>& block, const BlockMatesOf<Owned>& mates, Index number);

// Return views of the records of block `number`. The arrays of a view are in the record, which must outlive the view.
// Throw Error if the bytes are not a record of this kind.
[[nodiscard]] Block view_cells(std::span<const std::byte> record, Index number, const BlockNumbers& numbers);
[[nodiscard]] BlockAround view_around(std::span<const std::byte> record, Index number, const BlockNumbers& numbers,
                                      const Block& block);
[[nodiscard]] BlockMates view_mates(std::span<const std::byte> record, Index number, const BlockNumbers& numbers,
                                    const Block& block);

} // namespace ciel::detail
