// Cuts one block at one nu: finds its active cells and runs Algorithm 4 of the paper in them.
#pragma once

#include "blocks/active_block.hpp"
#include "blocks/blocks.hpp"
#include "blocks/pair_half_edges.hpp"
#include "ciel/decider.hpp"
#include "fields/cell_ranges.hpp"

namespace ciel {

// Buffers for cutting many blocks; one object per thread. The buffers by local vertex, edge and half-edge have room for
// all ids of 16 bits, because a record may change after its check (block.hpp).
struct CutScratch {
    struct ActiveCell {
        Index index; // index of the cell in its section
        Index high;  // one bit per corner of a standard cell, set if high; 0 for polyhedra
    };
    std::vector<std::uint8_t> high;              // by local vertex: 1 if high; zero-padded to a multiple of 64
    std::uint64_t low_parts = 0, high_parts = 0; // one bit per part of the vertices: set if it has low (high) ones
    std::vector<ActiveCell> cell;                // active cells of one section, ascending, then unused entries
    Index cells = 0;                             // number of active cells in `cell`
    std::vector<std::array<Index, 2>> ends;      // end vertices by active local edge; for MetEdges, by point
    std::vector<std::uint64_t> active;           // for SharedEdges: one bit per local edge, set if active
    // For MetEdges, by local edge: met_before + the point of the edge; less than met_before if the edge has no point in
    // this cut.
    std::vector<Index> met;
    Index met_before = 1, met_count = 0, met_most = 0;
    std::vector<std::uint64_t> crossed_cells; // a bit per cell of the polyhedra, set if a face has low and high corners
    // A face of a polyhedron that nu crosses. Bit i of `climbs` is set if the edge that begins at corner i of the
    // stored loop goes from low to high; bit i of `descends`, if it goes from high to low. A face with more than 64
    // corners is always listed, with all bits of `climbs` set.
    struct CrossedFace {
        Index face, side;
        std::uint64_t climbs, descends;
    };
    std::vector<CrossedFace> crossed;
    // For the face of a polyhedron that a polygon enters over one edge: the edge over which the polygon leaves the
    // face.
    struct Way {
        Index stamp = 0; // cell_stamp of the cell for which `exit` is valid
        Index exit = 0;
    };
    std::vector<Way> way; // by local edge over which a face is entered
    Index cell_stamp = 0;
    std::vector<Index> entry;
    std::vector<Index> returning; // edges over which the same face is entered and left
    std::vector<std::array<Index, 2>> crossing;
    std::vector<std::uint8_t> walked; // by half-edge of the polyhedra: 1 if a polygon has passed it
    HalfEdgePairs pairs;
    std::vector<Index> mate; // by half-edge of the polyhedra; only those of the cell being walked are valid
    struct Sorted {
        std::vector<Index> order, cell, end, edge;
    };
    Sorted sorted; // buffers for sorting the polygons of several sections by cell

    [[nodiscard]] std::span<const ActiveCell> active_cells() const { return std::span(cell).first(cells); }
};

[[nodiscard]] CutScratch& scratch_of_this_thread();

// Sets high[i] to 1 if values[i] >= threshold, else to 0. `high` must not overlap `values`.
void mark_high(const float* values, std::size_t count, float threshold, std::uint8_t* high);
void mark_high(const double* values, std::size_t count, double threshold, std::uint8_t* high);
// Classifies the block's vertices into scratch.high and cut.signature. Returns true when the cut is known and the
// signature is unchanged. A vertex without a value counts as low, so callers ignore the result for blocks with gaps.
bool classify(ValuesView values, double threshold, CutScratch& scratch, ActiveBlock& cut);

struct BlockValues {
    ValuesView values; // by local vertex; NaN where a vertex has no value
    bool gaps = false; // some vertex has no value; cells that touch such a vertex are skipped
    double threshold = 0;
    double nu = 0;
    Decider decider = Decider::isolate_high;
    std::span<const CellRanges::Range> ranges; // by group of cells (CellRanges::of), or empty
    bool naive = false;                        // tests every cell of the block
};

// Cuts the block into `cut`. Call `classify` with the same scratch and cut before.
void cut_block(const Block& block, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut);
// Cuts the block for output that is not kept and shares no points with other blocks. Classifies the vertices itself. Of
// `cut`, sets only the polygons; polygon_edge then holds point numbers. Sets scratch.met_count to the number of points,
// and scratch.ends to the end vertices of the edge of each point.
void cut_block_alone(const Block& block, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut);
// Like cut_block and cut_block_alone, but test only `cells`: local ids, ascending, of all cells that may be active.
void cut_cells(const Block& block, const BlockValues& in, std::span<const Index> cells, CutScratch& scratch,
               ActiveBlock& cut);
void cut_cells_alone(const Block& block, const BlockValues& in, std::span<const Index> cells, CutScratch& scratch,
                     ActiveBlock& cut);

// Cut the active cells of one section, which are in scratch.cell. Edges: SharedEdges or MetEdges (active_edges.hpp).
template <class Edges>
void cut_standard(const StandardSection& section, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut);
template <class Edges, class Local>
void cut_polyhedra(const PolyhedralSection<Local>& section, const BlockValues& in, CutScratch& scratch,
                   ActiveBlock& cut);

} // namespace ciel
