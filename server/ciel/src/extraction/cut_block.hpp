// How a block is cut: finds its active cells and runs Algorithm 4 in them.
#pragma once

#include "blocks/active_block.hpp"
#include "blocks/blocks.hpp"
#include "ciel/decider.hpp"
#include "fields/cell_ranges.hpp"

namespace ciel {

// Returns the smallest float >= nu: value >= nu and value >= threshold are the same for every float value. Returns
// infinity for NaN; no finite value reaches it.
[[nodiscard]] float threshold_of(double nu);

// Scratch for many blocks, one per thread.
struct CutScratch {
    struct ActiveCell {
        Index index; // in its section
        Index high;  // of a standard cell: one bit per corner
    };
    std::vector<std::uint8_t> high;              // per local vertex; zero-padded to a multiple of 64
    std::uint64_t low_parts = 0, high_parts = 0; // one bit per part of the vertices: has low or high ones
    std::vector<ActiveCell> cell;                // room for all cells of a block
    Index cells = 0;                             // number of active cells of one section; they ascend
    std::vector<std::array<Index, 2>> ends;      // per local edge, valid if active; by point in cut_block_alone
    // For cut_block_alone, per local edge: its point + met_before; less if the edge is new to this cut.
    std::vector<Index> met;
    Index met_before = 1, met_count = 0, met_most = 0;
    std::vector<std::uint8_t> face_kinds; // per face of the polyhedra: 1 has low corners, 2 has high ones
    // Faces of one polyhedron that nu crosses. One bit per corner of the stored loop: the edge that begins there climbs
    // or descends. A face with more than 64 corners is always listed, with all bits of `climbs` set.
    struct CrossedFace {
        Index face, side;
        std::uint64_t climbs, descends;
    };
    std::vector<CrossedFace> crossed;
    // For one polyhedron: the exit edge of the face that is entered over an edge.
    struct Way {
        Index stamp = 0; // of the cell for which it is valid
        Index exit = 0;
    };
    std::vector<Way> way; // per local edge
    Index cell_stamp = 0;
    std::vector<Index> entry;
    std::vector<Index> returning; // edges by which one face is both entered and left
    std::vector<std::array<Index, 2>> crossing;
    std::vector<std::uint8_t> walked; // per half-edge of the polyhedra
    struct Sorted {
        std::vector<Index> order, cell, end, edge;
    };
    Sorted sorted; // for polygons of several sections

    [[nodiscard]] std::span<const ActiveCell> active_cells() const { return std::span(cell).first(cells); }
};

[[nodiscard]] CutScratch& scratch_of_this_thread();

// Sets high[i] to 1 if values[i] >= threshold, else to 0. `high` must not overlap `values`.
void mark_high(const float* values, std::size_t count, float threshold, std::uint8_t* high);
// Classifies the block's vertices into scratch.high and cut.signature. Returns true when the cut is known and the
// signature is unchanged. A vertex without a value counts as low, so callers ignore the result for blocks with gaps.
bool classify(std::span<const float> values, float threshold, CutScratch& scratch, ActiveBlock& cut);

struct BlockValues {
    std::span<const float> values; // NaN where there is none
    bool gaps = false;             // some vertex has none: cells that touch it are skipped
    float threshold = 0;
    double nu = 0;
    Decider decider = Decider::isolate_high;
    std::span<const CellRanges::Range> ranges; // may be empty
    bool naive = false;                        // visits each cell
};

// Cuts the block. Call `classify` with the same scratch before.
void cut_block(const Block& block, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut);
// For cuts that are neither kept nor joined with other blocks. Classifies the vertices itself. Sets only the polygons
// of `cut`; their edges are point numbers. scratch.ends has the edge ends of the scratch.met_count points.
void cut_block_alone(const Block& block, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut);
// The same two for known candidates. `cells`: local ids, ascending, of all cells that may be active.
void cut_cells(const Block& block, const BlockValues& in, std::span<const Index> cells, CutScratch& scratch,
               ActiveBlock& cut);
void cut_cells_alone(const Block& block, const BlockValues& in, std::span<const Index> cells, CutScratch& scratch,
                     ActiveBlock& cut);

// Cut one section, for the functions above. The active cells are in scratch.cell. Edges: see active_edges.hpp.
template <class Edges>
void cut_standard(const StandardSection& section, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut);
template <class Edges, class Local>
void cut_polyhedra(const PolyhedralSection<Local>& section, const BlockValues& in, CutScratch& scratch,
                   ActiveBlock& cut);

} // namespace ciel
