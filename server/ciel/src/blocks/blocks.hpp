// The layout behind Topology, for the kernel's own files. A block has three records: its cells (block.hpp), what leads
// around its vertices (block_around.hpp), and the mates of its half-edges (block_mates.hpp).
#pragma once

#include "blocks/block_records.hpp"

namespace ciel {

struct BlockVertex {
    Index block, vertex;
};

struct BorderVertex {
    Index block, place; // place: index in border_vertex of the block
};

struct Topology::Blocks {
    BlockNumbers numbers;
    struct Records {
        RecordBytes cells, around, mates;
    };
    std::vector<Records> records; // what the views of each block lie in
    std::vector<Block> block;
    std::vector<BlockAround> around;
    std::vector<BlockMates> mates;
    TopologyCounts counts;

    [[nodiscard]] Index block_of_cell(Index cell) const;
    // Returns the vertex in the block that owns it, or {none, none} if no cell has it.
    [[nodiscard]] BlockVertex first_with(Index vertex) const;
    [[nodiscard]] BorderVertex next_in_ring(BorderVertex at) const {
        const BlockAround& here = around[at.block];
        return here.with([&](const auto& all) {
            return BorderVertex{here.neighbour[all.border_block[at.place]], all.border_place[at.place]};
        });
    }
    [[nodiscard]] Index vertex_at(BorderVertex at) const {
        return around[at.block].with([&](const auto& all) { return Index{all.border_vertex[at.place]}; });
    }
    // Returns the first half-edge in the block that leaves the vertex; no_half_edge if only collapsed faces have the
    // vertex.
    [[nodiscard]] HalfEdge first_at(BlockVertex at) const;
    // Returns the first half-edge that leaves the vertex at `entry`. If `entry` is end_of_list, continues in the next
    // block of the ring of the vertex.
    [[nodiscard]] HalfEdge first_after(Index block, Index entry, Index local_vertex) const;
    // Returns the first half-edge that leaves the vertex in the blocks after at.block around its ring, at.block itself
    // last.
    [[nodiscard]] HalfEdge first_after_block(BlockVertex at) const;
    // Returns the half-edge that is `steps` before h in its face. `face_size`: number of half-edges of the face.
    [[nodiscard]] HalfEdge turn_back(HalfEdge h, Index steps, Index face_size) const;
};

} // namespace ciel
