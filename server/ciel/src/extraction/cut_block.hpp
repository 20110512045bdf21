// What one query knows of one block, and how a block is cut: which cells are active, and Algorithm 4 in them.
#pragma once

#include "blocks/active_block.hpp"
#include "blocks/blocks.hpp"
#include "ciel/decider.hpp"
#include "fields/cell_ranges.hpp"

namespace ciel {

// The smallest float that is not below nu: value >= nu and value >= threshold are the same for every float value.
// No value reaches the threshold of a nu that is not a number.
[[nodiscard]] float threshold_of(double nu);

// Scratch for many blocks, one per thread.
struct CutScratch {
    struct ActiveCell {
        Index index; // in its section
        Index high;  // of a standard cell: one bit per corner
    };
    std::vector<std::uint8_t> high;              // per local vertex; zeros up to a multiple of 64
    std::uint64_t low_parts = 0, high_parts = 0; // a bit for each part of the vertices that has low or high ones
    std::vector<ActiveCell> cell;                // room for all of a block's
    Index cells = 0;                             // how many are active, of one section, ascending
    std::vector<std::array<Index, 2>> ends;      // per local edge, good where active; or by point (cut_block_alone)
    // Of cut_block_alone, per local edge: its point + met_before; less where this cut has not met it.
    std::vector<Index> met;
    Index met_before = 1, met_count = 0, met_most = 0;
    std::vector<std::uint8_t> face_kinds; // per face of the polyhedra: 1 has low corners, 2 has high ones
    // Of one polyhedron: the faces that nu crosses. A bit per corner of the stored loop, where the edge that begins
    // there climbs or descends; of a face with more than 64 all are set.
    struct CrossedFace {
        Index face, side;
        std::uint64_t climbs, descends;
    };
    std::vector<CrossedFace> crossed;
    // Of one polyhedron: where the face that is entered over an edge is left.
    struct Way {
        Index stamp = 0; // of the cell that it is good for
        Index exit = 0;
    };
    std::vector<Way> way; // per local edge
    Index cell_stamp = 0;
    std::vector<Index> entry;
    std::vector<Index> returning; // edges that a face is entered and left by
    std::vector<std::array<Index, 2>> crossing;
    std::vector<std::uint8_t> walked; // per half-edge of the polyhedra
    struct Sorted {
        std::vector<Index> order, cell, end, edge;
    };
    Sorted sorted; // polygons of several sections

    [[nodiscard]] std::span<const ActiveCell> active_cells() const { return std::span(cell).first(cells); }
};

[[nodiscard]] CutScratch& scratch_of_this_thread();

// high[i] = values[i] >= threshold, as 0 or 1; `high` overlaps nothing.
void mark_high(const float* values, std::size_t count, float threshold, std::uint8_t* high);
// Classifies the block's vertices into scratch.high and the signature; true when it is the one the cut was made for.
// (It does not tell a vertex without a value from a low one: the caller never trusts it where there are such.)
bool classify(std::span<const float> values, float threshold, CutScratch& scratch, ActiveBlock& cut);

struct BlockValues {
    std::span<const float> values; // NaN where there is none
    bool gaps = false;             // some vertex has none: cells that touch one are passed over
    float threshold = 0;
    double nu = 0;
    Decider decider = Decider::isolate_high;
    std::span<const CellRanges::Range> ranges; // may be empty
    bool naive = false;                        // each cell is looked at
};

// After `classify` with the same scratch.
void cut_block(const Block& block, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut);
// For one value after another, none of which is kept or joined with other blocks': classifies by itself. The polygons'
// edges are points, which scratch.ends tells the edges of, scratch.met_count of them. Of `cut` only the polygons are
// made.
void cut_block_alone(const Block& block, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut);
// The same two where it is known which cells may be active: local cells, ascending.
void cut_cells(const Block& block, const BlockValues& in, std::span<const Index> cells, CutScratch& scratch,
               ActiveBlock& cut);
void cut_cells_alone(const Block& block, const BlockValues& in, std::span<const Index> cells, CutScratch& scratch,
                     ActiveBlock& cut);

// Of one section, for those above. The active cells are in scratch.cell; Edges: see active_edges.hpp.
template <class Edges>
void cut_standard(const StandardSection& section, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut);
template <class Edges, class Local>
void cut_polyhedra(const PolyhedralSection<Local>& section, const BlockValues& in, CutScratch& scratch,
                   ActiveBlock& cut);

} // namespace ciel
