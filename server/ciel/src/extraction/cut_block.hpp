// Cuts one block at the iso-value nu: finds the active cells and runs the paper's Algorithm 4 in them.
#pragma once

#include "blocks/active_block.hpp"
#include "blocks/blocks.hpp"
#include "blocks/pair_half_edges.hpp"
#include "ciel/decider.hpp"
#include "fields/cell_ranges.hpp"

namespace ciel::detail {

// One object for each thread. The buffers have room for all 16-bit ids, because a record may change (block.hpp).
struct CutScratch {
    struct ActiveCell {
        Index index; // index of the cell in its section
        Index high;  // one bit for each corner of a standard cell, set if the corner is high; 0 for polyhedra
    };
    std::vector<std::uint8_t> high; // by local vertex: 1 if high; padded with 0 to a multiple of 64
    // One bit for each part of the vertices (Block::vertices_per_part), set if the part has low (high) vertices.
    std::uint64_t low_parts = 0, high_parts = 0;
    std::vector<ActiveCell> cell;           // active cells of one section, ascending, then unused entries
    Index cells = 0;                        // number of active cells in `cell`
    std::vector<std::array<Index, 2>> ends; // by active local edge: its two vertices; for MetEdges, by point
    std::vector<std::uint64_t> active;      // for SharedEdges: one bit for each local edge, set if active
    std::size_t active_words = 0;           // number of words of `active` that may not be 0
    // For MetEdges, by local edge: met_before + number of the edge's point; less than met_before if it has no point.
    std::vector<Index> met;
    Index met_before = 1, met_count = 0, met_most = 0;
    // One bit for each cell of the polyhedra, set if the cell has a face with low and high corners.
    std::vector<std::uint64_t> crossed_cells;
    // Edge i of a face begins at corner i of the stored loop. Bit i of `climbs` is set if edge i goes from low to high;
    // bit i of `descends`, if from high to low. A face with more than 64 corners has all bits of `climbs` set.
    struct CrossedFace {
        Index face, side;
        std::uint64_t climbs, descends;
    };
    std::vector<CrossedFace> crossed;
    // A polygon enters a face of a polyhedron over one edge, and leaves the face over the edge `exit`.
    struct Way {
        Index stamp = 0; // `exit` is valid only if this equals cell_stamp
        Index exit = 0;
    };
    std::vector<Way> way; // by local edge over which a polygon enters a face
    Index cell_stamp = 0;
    std::vector<Index> entry;
    std::vector<Index> returning; // edges over which a polygon enters and leaves the same face
    std::vector<std::array<Index, 2>> crossing;
    std::vector<std::uint8_t> walked; // by half-edge of the polyhedra: 1 if a polygon has passed it
    HalfEdgePairs pairs;
    std::vector<Index> mate; // by half-edge of the polyhedra; valid only for the half-edges of the current cell
    struct Sorted {
        std::vector<Index> order, cell, end, edge;
    };
    Sorted sorted; // buffers for sorting polygons by cell

    [[nodiscard]] std::span<const ActiveCell> active_cells() const { return std::span(cell).first(cells); }
};

struct BlockValues {
    ValuesView values; // by local vertex; NaN where a vertex has no value
    bool gaps = false; // whether some vertex has no value; cells with such a vertex are not cut
    double threshold = 0;
    double nu = 0;
    Decider decider = Decider::isolate_high;
    std::span<const CellRanges::Range> ranges; // by group of cells (CellRanges::of); may be empty
    bool naive = false;                        // if true, tests every cell of the block
};

// Cuts the block and writes the result to `cut`. REQUIRES: `classify` (classify_vertices.hpp) was called with the same
// scratch and cut.
void cut_block(const Block& block, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut);
// Cuts the block for output that is not kept and shares no points with other blocks. Classifies the vertices itself. In
// `cut`, sets only the polygons; polygon_edge has point numbers. Sets scratch.met_count, and scratch.ends for each
// point.
void cut_block_alone(const Block& block, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut);
// Like cut_block and cut_block_alone, but test only `cells`: the local ids of all cells that may be active, ascending.
void cut_cells(const Block& block, const BlockValues& in, std::span<const Index> cells, CutScratch& scratch,
               ActiveBlock& cut);
void cut_cells_alone(const Block& block, const BlockValues& in, std::span<const Index> cells, CutScratch& scratch,
                     ActiveBlock& cut);

// Edges: SharedEdges or MetEdges (active_edges.hpp).
template <class Edges>
void cut_standard(const StandardSection& section, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut);
template <class Edges, class Local>
void cut_polyhedra(const PolyhedralSection<Local>& section, const BlockValues& in, CutScratch& scratch,
                   ActiveBlock& cut);

} // namespace ciel::detail
