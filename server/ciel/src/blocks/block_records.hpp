// Writes the three records of a block, and views them (not in the paper). A record has no pointer and no mesh-wide
// number. It refers to another block by an index into its list of neighbors. The list has the difference between the
// numbers of the two blocks. Local ids of cells, vertices and edges have the order of the mesh-wide ids.
#pragma once

#include "blocks/block_around.hpp"
#include "blocks/block_mates.hpp"
#include "blocks/record.hpp"

namespace ciel::detail {

// The first four lists have one entry per block, and then the first unused id.
struct BlockNumbers {
    std::vector<Index> cell, vertex, edge; // first cell, first owned vertex and first owned edge of each block
    std::vector<Index> slot;               // sum of vertex_count of all earlier blocks (Block::vertex_begin)
    // By block: number of half-edges and of border vertices. Links from other blocks are checked against these numbers.
    std::vector<Index> half_edges, border_vertices;

    [[nodiscard]] std::size_t block_count() const { return cell.empty() ? 0 : cell.size() - 1; }
};

// The ghosts of a block as pairs (neighbor, index among the ids that the neighbor owns), as a record has them.
struct NamedGhosts {
    std::vector<std::array<std::uint16_t, 2>> narrow;
    std::vector<std::array<std::uint32_t, 2>> wide; // if an index needs 32 bits
};
struct BlockGhosts {
    std::vector<Index> neighbours; // the owners of all ghosts, ascending
    NamedGhosts vertices, edges;
};
// Returns the ghosts of the block in the form of a record. `vertex_begin`, `edge_begin`: the first id that each block
// owns, for all blocks up to this one.
[[nodiscard]] BlockGhosts name_ghosts(const BlockOf<Owned>& block, std::span<const Index> vertex_begin,
                                      std::span<const Index> edge_begin);

// Return the records of a block. `number`: number of the block. `types`: cell type of each of its standard sections.
[[nodiscard]] RecordBytes record_of(const BlockOf<Owned>& block, const BlockGhosts& ghosts, Index number);
[[nodiscard]] RecordBytes record_of(const BlockAroundOf<Owned>& around, std::span<const CellType> types, Index number);
[[nodiscard]] RecordBytes record_of(const BlockMatesOf<Owned>& mates, std::span<const CellType> types, Index number);

// Return views of the records of block `number`. The arrays of a view are in the record, which must outlive the view.
// Throw Error if the bytes are not a record of this kind.
[[nodiscard]] Block view_cells(std::span<const std::byte> record, Index number, const BlockNumbers& numbers);
[[nodiscard]] BlockAround view_around(std::span<const std::byte> record, Index number, const BlockNumbers& numbers,
                                      const Block& block);
[[nodiscard]] BlockMates view_mates(std::span<const std::byte> record, Index number, const BlockNumbers& numbers,
                                    const Block& block);

} // namespace ciel::detail
