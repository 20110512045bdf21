// Second half of the paper's Algorithm 5 (appendix A): builds the local vertices, edges and half-edges of one block.
#pragma once

#include "blocks/block_around.hpp"
#include "blocks/block_loops.hpp"
#include "blocks/block_mates.hpp"
#include "blocks/recognise.hpp"

namespace ciel::detail {

// A block that is not yet linked to other blocks, with tables that only the BlockLinker needs.
struct BuiltBlock {
    BlockOf<Owned> block; // ghost and owned vertices and edges are not yet separated
    BlockAroundOf<Owned> around;
    BlockMatesOf<Owned> mates;
    std::vector<Index> vertices;                 // local vertex -> mesh vertex
    std::vector<std::array<Index, 2>> edge_ends; // local edge -> its local end vertices, the lower first
    // One side of a face. The mates of its half-edges are in another block or section, or do not exist.
    struct Tail {
        Index face, side; // mesh face; side 0 is the owner's, side 1 the neighbor's
        Index other_cell; // mesh cell on the other side, or none
        Index anchor;     // local half-edge that leaves the face's first corner (side 0) or leads to it (side 1)
        Index steps;      // steps around the face from its first half-edge to the anchor
        Index mate;       // the anchor's mate if it is in another section of this block; else none
    };
    std::vector<Tail> tails; // the mate of tails[i] is twin i of `mates`
};

// Each thread needs its own object. `source` must outlive the object.
class BlockBuilder {
public:
    explicit BlockBuilder(const FaceSource& source) : loops_(source) {}

    // Builds the block of the cells [cell_begin, cell_end). Throws Error with the id of a cell that is not closed.
    [[nodiscard]] BuiltBlock build(Index cell_begin, Index cell_end);

private:
    struct Recognised {
        Index cell;
        StandardCell found;
    };

    [[nodiscard]] CellType type_of(Index local_cell) const;
    void sort_cells();
    [[nodiscard]] bool fits_16_bits() const;
    template <class Local>
    void fill(BuiltBlock& built);
    template <const StandardShape& shape>
    void fill_standard(BuiltBlock& built, std::span<const Recognised> cells);
    template <const StandardShape& shape>
    void set_anchors(std::span<const Recognised> cells, Index half_edge_begin);
    void set_standard_mates(BuiltBlock& built);
    template <class Local>
    void list_entries(const BlockOf<Owned>& block, BlockAroundOf<Owned>& around);

    BlockLoops loops_;
    std::array<std::vector<Recognised>, 4> standard_; // by index in standard_types
    std::vector<Index> polyhedra_;                    // local ids of the cells that are not standard
    std::vector<std::array<Index, 2>> anchor_;        // [loop][side]: as BuiltBlock::Tail::anchor, or none
};

// Fills the PolyhedralSection of `built` with `cells`. Appends a tail for each face that only one of `cells` has. Sets
// anchor[loop][side] (BuiltBlock::Tail::anchor) for each side that belongs to one of `cells`. Throws Error with the id
// of a cell that is not closed.
template <class Local>
void fill_polyhedra(const BlockLoops& loops, std::span<const Index> cells, BuiltBlock& built,
                    std::span<std::array<Index, 2>> anchor);

} // namespace ciel::detail
