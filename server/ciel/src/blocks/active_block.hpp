// The cut of one block: which of its edges are active and which polygons they make (paper, algorithm 4).
#pragma once

#include "ciel/types.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace ciel {

// The cut of one block at one nu. It depends only on which vertices are high, unless `decided` is set, so it is kept
// while the same vertices are high. The next cut reuses the buffers.
struct ActiveBlock {
    std::vector<std::uint64_t> signature;   // one bit per local vertex, set if high
    bool known = false;                     // whether the other members are the cut of `signature`
    std::vector<std::uint64_t> active;      // one bit per local edge, set if active
    std::vector<Index> rank;                // number of active edges before each word of `active`
    std::vector<std::array<Index, 2>> ends; // by active edge, ascending: local end vertices, the lower first
    Index ghosts = 0;                       // number of active ghost edges, which are the first of `ends`
    std::vector<Index> adopted;      // indices in `ends` of the ghosts whose points this block makes (AdoptedEdges)
    std::vector<Index> polygon_cell; // local cell of each polygon, ascending
    std::vector<Index> polygon_end;  // end of each polygon in polygon_edge
    std::vector<Index> polygon_edge; // local edges of each polygon
    bool wasted = false;             // some active edges may be in no polygon
    bool decided = false;            // a decider used nu on some face, so the cut depends on nu

    // First point, polygon and polygon corner of the block in the current surface. Set by write_surface.
    Index first_point = 0, first_polygon = 0, first_corner = 0;

    [[nodiscard]] Index owned() const { return static_cast<Index>(ends.size()) - ghosts; }
    // Returns the number of active edges before `edge`, which must be active.
    [[nodiscard]] Index place(Index edge) const {
        const std::uint64_t before = (std::uint64_t{1} << edge % 64) - 1;
        return rank[edge / 64] + static_cast<Index>(std::popcount(active[edge / 64] & before));
    }
};

} // namespace ciel
