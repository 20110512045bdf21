// Algorithm 5 of the paper (appendix A), second half, one block at a time: local vertices, edges and half-edges.
#pragma once

#include "blocks/block_around.hpp"
#include "blocks/block_loops.hpp"
#include "blocks/block_mates.hpp"
#include "blocks/recognise.hpp"

namespace ciel {

// A block before link_blocks, with tables that only link_blocks needs.
struct BuiltBlock {
    BlockOf<Owned> block; // ghost and owned vertices and edges are not yet separated
    BlockAroundOf<Owned> around;
    BlockMatesOf<Owned> mates;
    std::vector<Index> vertices;                 // local vertex -> mesh vertex
    std::vector<std::array<Index, 2>> edge_ends; // local edge -> its local end vertices, the lower first
    // A side of a face whose mate is in another block or section, or does not exist. link_blocks stores the mate of
    // such a side as a twin (BlockMates::twin).
    struct Tail {
        Index face, side; // mesh face; 0: side of the owner, 1: side of the neighbor
        Index anchor;     // local half-edge at the face's first corner: leaves it on side 0, leads to it on side 1
        Index steps;      // steps around the face from the half-edge whose mate is stored to the anchor
        Index mate;       // the anchor's mate if it is in another section of this block; else none
    };
    std::vector<Tail> tails; // tails[i] belongs to twin i
};

// Builds many blocks with the same buffers; one object per thread. Borrows the mesh and the lists of its cells' faces.
class BlockBuilder {
public:
    BlockBuilder(const FaceMeshView& mesh, const CellFaces& faces) : loops_(mesh, faces) {}

    // Builds the block of the cells [cell_begin, cell_end). Throws Error, naming the cell, when a cell is not closed.
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
    std::vector<Index> polyhedra_;                    // other cells of the block: local ids
    std::vector<std::array<Index, 2>> anchor_;        // [loop][side]: local half-edge at the first corner, or none
};

// Fills the PolyhedralSection of `built` with `cells`, and sets the mates of their half-edges. Their local half-edges
// and entries come after those of the standard sections. Faces with only one of `cells` become tails of `built`. Sets
// `anchor` for the sides of `cells`. Throws Error, naming the cell, when a cell is not closed.
template <class Local>
void fill_polyhedra(const BlockLoops& loops, std::span<const Index> cells, BuiltBlock& built,
                    std::span<std::array<Index, 2>> anchor);

} // namespace ciel
