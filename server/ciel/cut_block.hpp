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
    std::vector<Index> active;            // local edges, ascending: the owned ones, then ghosts
    Index owned = 0;                      // how many of them the block owns
    std::vector<Index> polygon_cell;      // local cell
    std::vector<Index> polygon_end;       // into polygon_point
    std::vector<Index> polygon_point;     // indices into `active`
    bool wasted = false;                  // a polygon was left out: some active edge may have none

    // Where the block's part of the current surface begins; set by write_surface.
    Index first_point = 0, first_polygon = 0, first_corner = 0;

    void clear_polygons();
};

// Scratch for many blocks, one per thread.
struct CutScratch {
    std::vector<Index> slot;          // local edge -> index into CutBlock::active, or none
    std::vector<std::uint8_t> walked; // local half-edge
    std::vector<Index> trail;         // half-edges to forget
    std::vector<Index> cells;
    std::vector<std::uint8_t> high; // local vertex
};

// Walks every loop of active edges of the given cells (local ids, ascending). `cut.active` and `scratch.slot` are set.
// `values` are the block's; with `gaps`, cells that touch a vertex without a value are passed over.
// Polygons of fewer than three distinct points are left out.
template <class Local>
void walk_cells(const Block& block, const BlockArrays<Local>& arrays, std::span<const float> values, float threshold,
                bool gaps, std::span<const Index> cells, CutScratch& scratch, CutBlock& cut);

} // namespace ciel
