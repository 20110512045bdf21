// The cut of one block: its active edges, which have one high and one low end, and its polygons, whose corners lie on
// active edges (paper, algorithm 4).
#pragma once

#include "ciel/types.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace ciel::detail {

// A vertex is high if its value is >= the iso-value nu, else low. The cut stays valid for every nu that leaves the same
// vertices high, unless `decided` is set. The next cut reuses the buffers.
struct ActiveBlock {
    std::vector<std::uint64_t> signature;   // one bit per local vertex, set if high
    bool known = false;                     // true if the other members are the cut for `signature`
    std::vector<std::uint64_t> active;      // one bit per local edge, set if active
    std::vector<Index> rank;                // by word of `active`: number of active edges in all earlier words
    std::vector<std::array<Index, 2>> ends; // by active edge, ascending: its local end vertices, lower id first
    Index ghosts = 0;                       // number of active ghost edges (Ghosts); they come first in `ends`
    std::vector<Index> adopted; // indices in `ends` of the ghost edges whose points this block makes (AdoptedEdges)
    std::vector<Index> polygon_cell; // local cell of each polygon, ascending
    std::vector<Index> polygon_end;  // by polygon: index after its last entry in polygon_edge
    std::vector<Index> polygon_edge; // local edges of the polygons, one per polygon corner
    bool wasted = false;             // true if some active edges may be in no polygon
    bool decided = false;            // true if a Decider used nu on a face; the cut then depends on nu

    // Indices of the first point, polygon and polygon corner of the block in the current surface. Set by write_surface.
    Index first_point = 0, first_polygon = 0, first_corner = 0;

    [[nodiscard]] Index owned() const { return static_cast<Index>(ends.size()) - ghosts; }
    // Returns the number of active edges before `edge`, which must be active.
    [[nodiscard]] Index place(Index edge) const {
        const std::uint64_t before = (std::uint64_t{1} << edge % 64) - 1;
        return rank[edge / 64] + static_cast<Index>(std::popcount(active[edge / 64] & before));
    }
};

} // namespace ciel::detail
