// Algorithm 5 of the paper (appendix A), second half, one block at a time: local vertices, edges and half-edges.
#pragma once

#include "blocks/block_loops.hpp"
#include "blocks/blocks.hpp"
#include "blocks/recognise.hpp"

namespace ciel {

// What the linking of blocks needs and the finished block does not.
struct BuiltBlock {
    Block block;                                 // vertices and edges not yet told into ghosts and own ones
    std::vector<Index> vertices;                 // local -> mesh
    std::vector<std::array<Index, 2>> edge_ends; // local
    // The half-edges whose mates Block::twin is to hold: in another block or section, or nowhere.
    struct Tail {
        Index face, side; // of the mesh
        Index anchor;     // local half-edge of that face at its first corner, along it or against it
        Index steps;      // from the half-edge whose mate is wanted to the anchor, around the face
        Index mate;       // of the anchor where it is in this block, in another section; or none
    };
    std::vector<Tail> tails; // by index into Block::twin
};

// Scratch for many blocks, one per thread; borrows the mesh and its cells' faces.
class BlockBuilder {
public:
    BlockBuilder(const FaceMeshView& mesh, const CellFaces& faces) : loops_(mesh, faces) {}

    // Throws Error naming the cell when a cell is not closed.
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
    template <class Local>
    void set_standard_mates(BuiltBlock& built, const BlockArrays<Local>& arrays);
    template <class Local>
    void list_entries(Block& block, BlockArrays<Local>& arrays);

    BlockLoops loops_;
    std::array<std::vector<Recognised>, 4> standard_; // by shape
    std::vector<Index> polyhedra_;                    // local cells
    std::vector<std::array<Index, 2>> anchor_;        // loop -> by side: its local half-edge there, or none
};

// Local half-edges and entries behind those of the standard sections. Faces with other than polyhedra of this block on
// them become tails of `built`; `anchor` gets the polyhedra's half-edges. Throws Error naming a cell that is not
// closed.
template <class Local>
void fill_polyhedra(const BlockLoops& loops, std::span<const Index> cells, BuiltBlock& built,
                    PolyhedralSection<Local>& out, std::span<std::array<Index, 2>> anchor);

// As turn of blocks.hpp, while the block's arrays are not in their place.
template <class Local>
[[nodiscard]] Index turn(const Block& block, const PolyhedralSection<Local>& polyhedra, Index local_half_edge,
                         Index steps);

} // namespace ciel
