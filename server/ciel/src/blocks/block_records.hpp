// A block's three records (not in the paper). The tables of BlockBuilder are written to records, and the kernel reads
// only the records afterwards. A record has no pointer, no position and no mesh-wide number: another block is an index
// into the record's list of neighbors, whose entries are distances between block numbers. Local ids of cells, vertices
// and edges have the order of the mesh-wide ids.
#pragma once

#include "blocks/block_around.hpp"
#include "blocks/block_mates.hpp"
#include "blocks/record.hpp"

namespace ciel {

// Where the ids of each block begin in the mesh. The first four lists have one more entry at the end.
struct BlockNumbers {
    std::vector<Index> cell, vertex, edge; // a block's first cell; its first owned vertex; its first owned edge
    std::vector<Index> slot;               // the sum of vertex_count of the blocks before (Block::vertex_begin)
    // By block: its numbers of half-edges and of border vertices, against which links from other blocks are checked.
    std::vector<Index> half_edges, border_vertices;

    [[nodiscard]] std::size_t block_count() const { return cell.empty() ? 0 : cell.size() - 1; }
};

[[nodiscard]] RecordBytes record_of(const BlockOf<Owned>& block, Index number, const BlockNumbers& numbers);
[[nodiscard]] RecordBytes record_of(const BlockOf<Owned>& block, const BlockAroundOf<Owned>& around, Index number);
[[nodiscard]] RecordBytes record_of(const BlockOf<Owned>& block, const BlockMatesOf<Owned>& mates, Index number);

// View the records of block `number`. The arrays stay in the record, which must outlive the view. Throw Error if the
// record does not have the sections of its kind.
[[nodiscard]] Block view_cells(std::span<const std::byte> record, Index number, const BlockNumbers& numbers);
[[nodiscard]] BlockAround view_around(std::span<const std::byte> record, Index number, const BlockNumbers& numbers,
                                      const Block& block);
[[nodiscard]] BlockMates view_mates(std::span<const std::byte> record, Index number, const BlockNumbers& numbers,
                                    const Block& block);

} // namespace ciel
