// The faces around one block's cells with local ids: what its sections are filled from. The first step of what
// block_builder.hpp does of Algorithm 5 (paper, appendix A).
#pragma once

#include "blocks/local_numbers.hpp"
#include "ciel/cell_faces.hpp"

#include <unordered_map>

namespace ciel {

// A face seen from one of its cells: 2 * loop + side, side 1 against the stored direction.
using LoopRef = Index;

// Scratch for many blocks, one per thread, as long as the largest of them; borrows the mesh and its cells' faces. Loops
// lack the repeats of collapsed cells; one that collapsed to a point is empty and in no cell's list. What is read of
// the mesh is read once and agrees with itself, also when the mesh changes meanwhile: else gather throws Error.
class BlockLoops {
public:
    BlockLoops(const FaceMeshView& mesh, const CellFaces& faces);

    void gather(Index cell_begin, Index cell_end);

    [[nodiscard]] Index loop_count() const { return static_cast<Index>(mesh_face.size()); }
    [[nodiscard]] Index size(LoopRef ref) const { return begin[ref / 2 + 1] - begin[ref / 2]; }
    // The i-th corner as the cell sees the loop from outside, counter-clockwise.
    [[nodiscard]] Index corner(LoopRef ref, Index i) const {
        return ref % 2 == 0 ? begin[ref / 2] + i : begin[ref / 2 + 1] - 1 - i;
    }
    [[nodiscard]] Index vertex_at(LoopRef ref, Index i) const { return vertex[corner(ref, i)]; }
    // The edge from the i-th corner to the next.
    [[nodiscard]] Index edge_at(LoopRef ref, Index i) const {
        return edge[ref % 2 == 0 ? corner(ref, i) : corner(ref, i + 1 == size(ref) ? 0 : i + 1)];
    }
    [[nodiscard]] std::span<const LoopRef> of_cell(Index local_cell) const {
        return std::span(cell_loop).subspan(cell_loop_begin[local_cell],
                                            cell_loop_begin[local_cell + 1] - cell_loop_begin[local_cell]);
    }
    // Local cell on a side of a loop, or none: in another block, or outside.
    [[nodiscard]] Index cell_on(Index loop, Index side) const {
        const Index cell = mesh_cell[loop][side];
        return cell >= cell_begin && cell < cell_end ? cell - cell_begin : none;
    }
    [[nodiscard]] bool is_boundary(Index loop) const { return mesh_cell[loop][1] == none; }

    const FaceMeshView& mesh;
    Index cell_begin = 0, cell_end = 0;
    std::vector<Index> mesh_face;                  // loop -> face: those the cells own, then those of earlier blocks
    std::vector<std::array<Index, 2>> mesh_cell;   // loop -> owner and neighbour
    std::vector<Index> begin;                      // loop -> first corner; one more at the end
    std::vector<Index> vertex, edge;               // per corner, local; the edge leads to the next corner
    std::vector<Index> vertices;                   // local -> mesh vertex, ascending
    std::vector<std::array<Index, 2>> edge_ends;   // local, lower vertex first; by first appearance in the loops
    std::vector<Index> cell_loop_begin, cell_loop; // by local cell, in the order of the mesh's faces

private:
    void list_faces();
    void copy_own(Index face_begin, Index face_end);
    [[nodiscard]] bool has_repeats() const;
    void remove_repeats();
    bool append(Index face);
    bool append_loop(std::span<const Index> ids);
    void check_sides() const;
    void number_vertices();
    void find_edges();
    Index edge_between(Index low, Index high); // a new one where there is none

    const CellFaces& faces_;
    std::vector<std::uint64_t> own_offset_;
    std::vector<Index> loop_;
    std::vector<Index> collapsed_;                          // vertices of loops that collapsed to a point
    LocalNumbers local_vertex_;                             // mesh vertex -> local
    std::vector<Index> edge_head_, edge_next_;              // edges by their lower vertex: the first ones of each
    std::unordered_map<std::uint64_t, Index> crowded_edge_; // the others: a vertex of thousands, say a fan's apex
};

} // namespace ciel
