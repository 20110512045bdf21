// The points of a surface of some blocks (Query::set_blocks) on edges that a left-out block owns. Not in the paper.
//
// The first block that has an edge owns the edge and makes its point. If this block is left out, the first remaining
// block that has the edge adopts it and makes the point. The point is the same, because all blocks have the same values
// at the ends of the edge.
#pragma once

#include "extraction/cutter.hpp"

namespace ciel {

// Reused from surface to surface. Not thread-safe.
class AdoptedEdges {
public:
    struct Edge {
        Index edge;       // of the mesh
        Index block, end; // the block that makes the point, and the index of the edge in its ActiveBlock::ends
        Index point;      // of the surface
    };

    // Finds the active edges of the cutter's blocks whose owners the cutter leaves out. Sets `adopted` of its cuts.
    void find(const Topology::Blocks& blocks, Cutter& cutter);
    // Numbers the points of the adopted edges below `edge` that have no number yet, from `next` on. Returns the next
    // free number. Call with ascending `edge`.
    [[nodiscard]] std::uint64_t number_below(Index edge, std::uint64_t next);

    [[nodiscard]] std::span<const Edge> edges() const { return edges_; } // ascending
    // Returns the point of the adopted edge with the mesh-wide id `edge`.
    [[nodiscard]] Index point_of(Index edge) const;
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    std::vector<Edge> edges_;
    std::size_t numbered_ = 0;
    std::vector<std::vector<Edge>> found_; // by active block
};

} // namespace ciel
