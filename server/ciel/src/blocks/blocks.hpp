// The layout behind Topology, for the kernel's own files. A block has three records: its cells (block.hpp), what leads
// around its vertices (block_around.hpp), and the mates of its half-edges (block_mates.hpp).
#pragma once

#include "blocks/block_records.hpp"
#include "blocks/record_source.hpp"
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
    // Return the views of a block's records, which are read when they are first asked for. Throw what the source
    // throws.
    [[nodiscard]] const Block& cells(Index b) const {
        return cells_.of(b, [&] { return view_cells(source->record(b, RecordKind::cells), b, numbers); });
    }
    [[nodiscard]] const BlockAround& around(Index b) const {
        return around_.of(b, [&] { return view_around(source->record(b, RecordKind::around), b, numbers, cells(b)); });
    }
    [[nodiscard]] const BlockMates& mates(Index b) const {
        return mates_.of(b, [&] { return view_mates(source->record(b, RecordKind::mates), b, numbers, cells(b)); });
    }
    [[nodiscard]] std::size_t memory_bytes() const;

    [[nodiscard]] Index block_of_cell(Index cell) const;
    // Returns the vertex in the block that owns it, or {none, none} if no cell has it.
    [[nodiscard]] BlockVertex first_with(Index vertex) const;
    [[nodiscard]] BorderVertex next_in_ring(BorderVertex at) const {
        const BlockAround& here = around(at.block);
        return here.with([&](const auto& all) {
            return BorderVertex{here.neighbour[all.border_block[at.place]], all.border_place[at.place]};
        });
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
    Touched<Block> cells_;
    Touched<BlockAround> around_;
    Touched<BlockMates> mates_;
};

} // namespace ciel
