// The layout behind Topology (paper, section 2.2), for the kernel's own files. A block has three records: its cells
// (block.hpp), what leads around its vertices (block_around.hpp), and the mates of its half-edges (block_mates.hpp).
#pragma once

#include "blocks/block_records.hpp"
#include "blocks/touched.hpp"

namespace ciel {

struct BlockVertex {
    Index block, vertex;
};

struct BorderVertex {
    Index block, place; // place: index in border_vertex of the block
};

struct Topology::Blocks {
    BlockNumbers numbers;
    TopologyCounts counts;
    std::unique_ptr<RecordSource> source;

    // Call when the numbers and the source are set.
    void begin();
    [[nodiscard]] Index count() const { return static_cast<Index>(numbers.block_count()); }
    [[nodiscard]] Index slot_count() const { return numbers.slot.empty() ? 0 : numbers.slot.back(); }
    // Return the views of a block's records, which are read and checked when they are first asked for. Throw what the
    // source throws, and Error if a record is damaged.
    [[nodiscard]] const Block& cells(Index b) const {
        return cells_.of(b, [&] { return read_cells(b); });
    }
    [[nodiscard]] const BlockAround& around(Index b) const {
        return around_.of(b, [&] { return read_around(b); });
    }
    [[nodiscard]] const BlockMates& mates(Index b) const {
        return mates_.of(b, [&] { return read_mates(b); });
    }
    [[nodiscard]] std::size_t memory_bytes() const;

    [[nodiscard]] Index block_of_cell(Index cell) const;
    // Returns the vertex in the block that owns it, or {none, none} if no cell has it.
    [[nodiscard]] BlockVertex first_with(Index vertex) const;
    // Returns the vertex in the next block that has it, on a walk that began in block `start`. Throws Error if a record
    // is damaged so that the walk would not come back there.
    [[nodiscard]] BorderVertex next_in_ring(BorderVertex at, Index start) const {
        const BlockAround& here = around(at.block);
        const auto next = here.with([&](const auto& all) {
            return BorderVertex{here.neighbour[all.border_block[at.place]], all.border_place[at.place]};
        });
        if (!is_trusted_) check_ring(at, next, start);
        return next;
    }
    [[nodiscard]] Index vertex_at(BorderVertex at) const {
        return around(at.block).with([&](const auto& all) { return Index{all.border_vertex[at.place]}; });
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

private:
    [[nodiscard]] Block read_cells(Index b) const;
    [[nodiscard]] BlockAround read_around(Index b) const;
    [[nodiscard]] BlockMates read_mates(Index b) const;
    void check_ring(BorderVertex at, BorderVertex next, Index start) const;

    Touched<Block> cells_;
    Touched<BlockAround> around_;
    Touched<BlockMates> mates_;
    bool is_trusted_ = true;
};

} // namespace ciel
