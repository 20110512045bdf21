// AdoptedEdges: the points of a surface on edges that a left-out block owns. A block is left out if the surface is made
// of some blocks only (Query::set_blocks). The first remaining block that has such an edge adopts the edge and makes
// its point. The point is the same, because all blocks have the same values at the ends of the edge. Not in the paper.
#pragma once

#include "extraction/cutter.hpp"

namespace ciel::detail {

// The object is reused for each surface. Not thread-safe.
class AdoptedEdges {
public:
    struct Edge {
        Index edge;       // mesh-wide id
        Index block, end; // block that adopts the edge, and index of the edge in ActiveBlock::ends of that block
        Index point;      // index of the point in the surface
    };

    // Finds the active edges whose owner is left out. Sets ActiveBlock::adopted in the cutter's cuts.
    void find(const Topology::Blocks& blocks, Cutter& cutter);
    // Numbers the points of the adopted edges with ids below `edge`, starting with `next`. Returns the next unused
    // number. `edge` must ascend from call to call.
    [[nodiscard]] std::uint64_t number_below(Index edge, std::uint64_t next);

    [[nodiscard]] std::span<const Edge> edges() const { return edges_; } // ascending by edge
    [[nodiscard]] Index point_of(Index edge) const;
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    std::vector<Edge> edges_;
    std::size_t numbered_ = 0;
    std::vector<std::vector<Edge>> found_; // by index in Cutter::active(): the edges found in that block
};

} // namespace ciel::detail
