// The cut of one block: which of its edges are active and which polygons they make (paper, algorithm 4).
#pragma once

#include "ciel/types.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace ciel {

// The cut of one block at one nu. It depends on which vertices are high, not on nu, so it is kept while those are the
// same. Buffers are kept for the next cut.
struct ActiveBlock {
    std::vector<std::uint64_t> signature;   // one bit per local vertex: high
    bool known = false;                     // the rest belongs to the signature
    std::vector<std::uint64_t> active;      // one bit per local edge
    std::vector<Index> rank;                // active edges before each word of `active`
    std::vector<std::array<Index, 2>> ends; // of the active edges, ascending: local vertices, the lower one first
    Index ghosts = 0;                       // how many of them, the first ones, other blocks own
    std::vector<Index> polygon_cell;        // local cell, ascending
    std::vector<Index> polygon_end;         // into polygon_edge
    std::vector<Index> polygon_edge;        // local edges
    bool wasted = false;                    // some active edge may have no polygon
    bool decided = false;                   // by nu, how to join the points of some face

    // Where the block's part of the current surface begins; set by the writer.
    Index first_point = 0, first_polygon = 0, first_corner = 0;

    [[nodiscard]] Index owned() const { return static_cast<Index>(ends.size()) - ghosts; }
    // The place of an active edge among them.
    [[nodiscard]] Index place(Index edge) const {
        const std::uint64_t before = (std::uint64_t{1} << edge % 64) - 1;
        return rank[edge / 64] + static_cast<Index>(std::popcount(active[edge / 64] & before));
    }
};

} // namespace ciel
