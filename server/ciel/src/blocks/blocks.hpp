// The layout behind Topology (paper, section 2.2), for the kernel's own files. A block has three records: its cells
// (block.hpp), the links around its vertices (block_around.hpp), and the mates of its half-edges (block_mates.hpp).
#pragma once

#include "blocks/block_records.hpp"
#include "blocks/touched.hpp"

namespace ciel::detail {

struct BlockVertex {
    Index block, vertex;
};

struct BorderVertex {
    Index block, place; // place: index in border_vertex of the block
};

// Ensures that a walk from half-edge to half-edge ends, even if the records change.
class WalkEnds {
public:
    explicit WalkEnds(const TopologyCounts& counts) : most_(counts.half_edges) {}

    // Call it at each step of the walk. Throws Error when the walk runs in a circle that does not contain its first
    // half-edge. Compares `h` with one earlier half-edge, which is replaced at the steps 8, 16, 32 and so on (Brent's
    // algorithm).
    void step(HalfEdge h) {
        if (h == seen_ || steps_ > most_) [[unlikely]]
            refuse_changed("the half-edges around a vertex do not come back to the first");
        if (++steps_ != next_) return;
        seen_ = h;
        next_ *= 2;
    }

private:
    std::uint64_t most_, steps_ = 0, next_ = 8;
    HalfEdge seen_ = no_half_edge;
};

} // namespace ciel::detail

namespace ciel {

struct Topology::Blocks {
    detail::BlockNumbers numbers;
    TopologyCounts counts;
    std::unique_ptr<RecordSource> source;

    // Call once, after `numbers` and `source` are set.
    void begin();
    [[nodiscard]] Index count() const { return static_cast<Index>(numbers.block_count()); }
    [[nodiscard]] Index slot_count() const { return numbers.slot.empty() ? 0 : numbers.slot.back(); }
    // Return the views of a block's records. The first call for a block reads the record and, if the source is not
    // trusted, checks it. Throw the exceptions of the source, and Error if a record is damaged.
    [[nodiscard]] const detail::Block& cells(Index b) const {
        return cells_.of(b, [&] { return read_cells(b); });
    }
    [[nodiscard]] const detail::BlockAround& around(Index b) const {
        return around_.of(b, [&] { return read_around(b); });
    }
    [[nodiscard]] const detail::BlockMates& mates(Index b) const {
        return mates_.of(b, [&] { return read_mates(b); });
    }
    [[nodiscard]] std::size_t memory_bytes() const;

    [[nodiscard]] Index block_of_cell(Index cell) const;
    // Returns the block that owns the vertex, and the local id of the vertex; {none, none} if no cell has the vertex.
    [[nodiscard]] detail::BlockVertex first_with(Index vertex) const;
    // Returns the next block in the ring of a border vertex, and the place of the vertex in this block. `start`: block
    // in which the walk around the ring began. Throws Error if a damaged ring does not lead to `start`.
    [[nodiscard]] detail::BorderVertex next_in_ring(detail::BorderVertex at, Index start) const {
        const detail::BlockAround& here = around(at.block);
        const auto next = here.with([&](const auto& all) {
            const Index block =
                at.place < all.border_block.size() ? Index{detail::read_once(all.border_block[at.place])} : none;
            if (block >= here.neighbour.size())
                detail::refuse_changed("a border vertex leads to a block that is not a neighbor");
            return detail::BorderVertex{here.neighbour[block], detail::read_once(all.border_place[at.place])};
        });
        if (!is_trusted_) check_ring(at, next, start);
        return next;
    }
    // Returns the local id of a border vertex. Throws Error if a changed record leads beyond the vertices of the block.
    [[nodiscard]] Index vertex_at(detail::BorderVertex at) const {
        const Index vertex = around(at.block).with([&](const auto& all) {
            return at.place < all.border_vertex.size() ? Index{detail::read_once(all.border_vertex[at.place])} : none;
        });
        if (vertex >= cells(at.block).vertex_count)
            detail::refuse_changed("a border vertex leads to a vertex that does not exist");
        return vertex;
    }
    // Returns the first half-edge that leaves the vertex; no_half_edge if only collapsed faces have the vertex.
    [[nodiscard]] HalfEdge first_at(detail::BlockVertex at) const;
    // Returns the first half-edge at `entry` that leaves the vertex. If `entry` is end_of_list, returns the result of
    // first_after_block.
    [[nodiscard]] HalfEdge first_after(Index block, Index entry, Index local_vertex) const;
    // Returns the first half-edge that leaves the vertex in the next block of its ring that has one, or no_half_edge.
    // The search ends with at.block itself.
    [[nodiscard]] HalfEdge first_after_block(detail::BlockVertex at) const;
    // Where a half-edge is stored: its block, the number of the block, and the local number. place_of throws Error if
    // the half-edge does not exist, because a record has changed or the caller passed an invalid half-edge.
    struct Place {
        const detail::Block& block;
        Index number, local;
    };
    [[nodiscard]] Place place_of(HalfEdge h) const {
        const Index b = detail::block_of(h), local = detail::local_of(h);
        if (b >= cells_.size()) [[unlikely]]
            refuse_half_edge();
        const detail::Block& block = cells(b);
        if (local >= block.half_edge_count) [[unlikely]]
            refuse_half_edge();
        return {block, b, local};
    }
    // Returns the half-edge that is `steps` before h in its face. `face_size`: number of half-edges of the face.
    [[nodiscard]] HalfEdge turn_back(HalfEdge h, Index steps, Index face_size) const;

private:
    [[nodiscard]] detail::Block read_cells(Index b) const;
    [[nodiscard]] detail::BlockAround read_around(Index b) const;
    [[nodiscard]] detail::BlockMates read_mates(Index b) const;
    void check_ring(detail::BorderVertex at, detail::BorderVertex next, Index start) const;
    [[noreturn]] static void refuse_half_edge();

    detail::Touched<detail::Block> cells_;
    detail::Touched<detail::BlockAround> around_;
    detail::Touched<detail::BlockMates> mates_;
    bool is_trusted_ = true;
};

} // namespace ciel
