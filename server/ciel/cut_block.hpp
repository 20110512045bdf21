// What one query knows of one block, and Algorithm 4: intersection polygons by turning around the faces of a cell.
#pragma once

#include "ciel/blocks.hpp"

namespace ciel {

// The smallest float that is not below nu: value >= nu and value >= threshold are the same for every float value.
// No value reaches the threshold of a nu that is not a number.
[[nodiscard]] float threshold_of(double nu);

// The cut of one block at one nu. It depends on which vertices are high, not on nu, so it is kept while those are the
// same. Buffers are kept for the next cut.
struct CutBlock {
    std::vector<std::uint64_t> signature; // one bit per local vertex: high
    bool known = false;                   // the rest belongs to the signature
    std::vector<Index> active;            // local edges, ascending
    Index ghosts = 0;                     // how many of them, the first ones, other blocks own
    std::vector<Index> polygon_cell;      // local cell, ascending
    std::vector<Index> polygon_end;       // into polygon_point
    std::vector<Index> polygon_point;     // indices into `active`
    bool wasted = false;                  // a polygon was left out: some active edge may have none

    // Where the block's part of the current surface begins; set by write_surface.
    Index first_point = 0, first_polygon = 0, first_corner = 0;

    [[nodiscard]] Index owned() const { return static_cast<Index>(active.size()) - ghosts; }
};

// Scratch for many blocks, one per thread.
struct CutScratch {
    struct Polygon {
        Index cell, begin, end; // in `point`
    };
    std::vector<std::uint8_t> high;   // local vertex
    std::vector<std::uint8_t> on;     // local edge: active
    std::vector<Index> slot;          // local edge -> index into CutBlock::active, or none
    std::vector<Index> entry;         // half-edges from a low to a high vertex, in any order
    std::vector<std::uint8_t> walked; // local half-edge
    std::vector<Index> point;
    std::vector<Polygon> polygon;
};

// Walks the loops that lead through the entries. `cut.active` and `scratch.entry` are set, one entry at least for each
// loop. With `gaps`, cells that touch a vertex without a value (NaN in `values`, the block's) are passed over. Polygons
// of fewer than three distinct points are left out. A cell's polygons and their first points are in the order of edge
// ids, so they depend on no other order.
template <class Local>
void walk_entries(const Block& block, const BlockArrays<Local>& arrays, std::span<const float> values, bool gaps,
                  CutScratch& scratch, CutBlock& cut);

} // namespace ciel
