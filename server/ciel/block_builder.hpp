// Algorithm 5 of the paper (appendix A), second half, one block at a time: local vertices, edges and half-edges.
#pragma once

#include "ciel/blocks.hpp"
#include "ciel/cell_faces.hpp"

namespace ciel {

// What the linking of blocks needs and the finished block does not.
struct BuiltBlock {
    Block block;                  // edges still in order of first corner, no ghosts marked
    std::vector<Index> tail_face; // mesh face of each tail face
};

// Scratch for many blocks, one per thread.
class BlockBuilder {
public:
    BlockBuilder(const FaceMeshView& mesh, const CellFaces& faces);

    // Throws Error naming the cell when a cell is not closed.
    [[nodiscard]] BuiltBlock build(Index cell_begin, Index cell_end);

private:
    template <class Local>
    void fill(BuiltBlock& built);
    void list_faces(BuiltBlock& built);
    void gather_loops(BuiltBlock& built);
    void collect_vertices(Block& block);
    template <class Local>
    void fill_corners(const Block& block, BlockArrays<Local>& arrays);
    template <class Local>
    void find_edges(const Block& block, BlockArrays<Local>& arrays);
    template <class Local>
    void list_cell_faces(Block& block, BlockArrays<Local>& arrays);
    template <class Local>
    void pair_half_edges(const Block& block, BlockArrays<Local>& arrays);
    template <class Local>
    void pair_half_edge(const Block& block, BlockArrays<Local>& arrays, Index h);
    template <class Local>
    void pair_inside_faces(const Block& block, BlockArrays<Local>& arrays, Index cell);

    const FaceMeshView& mesh_;
    const CellFaces& faces_;
    Index cell_begin_ = 0, cell_end_ = 0, face_begin_ = 0, face_end_ = 0; // faces the block's cells own
    std::vector<Index> inner_, near_tail_, far_tail_;                     // mesh faces
    std::vector<Index> local_face_;    // owned mesh face - face_begin_ -> local face, none when it has no half-edge
    std::vector<Index> corner_vertex_; // mesh vertex of each corner
    std::vector<Index> local_vertex_;  // mesh vertex -> local, none outside this block
    std::vector<Index> edge_head_, edge_next_; // edges by their lower vertex
    std::vector<Index> open_, open_next_;      // local edge -> half-edges of the cell that wait for a mate
    std::vector<Index> waiting_;               // edges whose list got an entry
};

} // namespace ciel
