// The points of a surface of some blocks that lie on edges of the other blocks. Not in the paper.
//
// Each edge of the mesh belongs to the first block that has it, which makes the point. If that block is left out, the
// first of the remaining blocks that has the edge makes the same point, since all of them have the same values at its
// ends.
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
    // Gives the next points, from `next` on, to the edges below `edge`. Returns the point after them. Call with
    // ascending edges.
    [[nodiscard]] std::uint64_t number_below(Index edge, std::uint64_t next);

    [[nodiscard]] std::span<const Edge> edges() const { return edges_; } // ascending
    // Returns the point of an edge of an owner that is left out.
    [[nodiscard]] Index point_of(Index edge) const;
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    std::vector<Edge> edges_;
    std::size_t numbered_ = 0;
    std::vector<std::vector<Edge>> found_; // by active block
};

} // namespace ciel
