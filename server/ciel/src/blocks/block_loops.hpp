// The faces of the cells of one block, with local ids: the first step of Algorithm 5 (paper, appendix A) in a block.
#pragma once

#include "blocks/local_numbers.hpp"
#include "mesh/face_source.hpp"

#include <span>
#include <unordered_map>

namespace ciel::detail {

// One side of a face, stored as 2 * loop + side. Side 0 runs along the stored loop, side 1 against the stored loop.
using LoopRef = Index;

// One object serves many blocks. Each thread needs its own object. `source` must outlive the object.
// `vertex` holds local vertices. Repeated vertices, which collapsed cells have, are removed from the loops. A loop that
// collapsed to a point is empty, and no cell has it in its list.
class BlockLoops : public FaceLoops {
public:
    explicit BlockLoops(const FaceSource& source) : source_(source) {}

    // Throws Error when the faces of the cells contradict each other.
    void gather(Index cell_begin, Index cell_end);

    [[nodiscard]] Index size(LoopRef ref) const { return begin[ref / 2 + 1] - begin[ref / 2]; }
    // Returns the i-th corner of the loop, counter-clockwise as seen from outside the cell.
    [[nodiscard]] Index corner(LoopRef ref, Index i) const {
        return ref % 2 == 0 ? begin[ref / 2] + i : begin[ref / 2 + 1] - 1 - i;
    }
    [[nodiscard]] Index vertex_at(LoopRef ref, Index i) const { return vertex[corner(ref, i)]; }
    [[nodiscard]] Index edge_at(LoopRef ref, Index i) const {
        return edge[ref % 2 == 0 ? corner(ref, i) : corner(ref, i + 1 == size(ref) ? 0 : i + 1)];
    }
    [[nodiscard]] std::span<const LoopRef> of_cell(Index local_cell) const {
        return std::span(cell_loop).subspan(cell_loop_begin[local_cell],
                                            cell_loop_begin[local_cell + 1] - cell_loop_begin[local_cell]);
    }
    // Returns the local cell on a side of the loop; none if the cell is in another block or does not exist.
    [[nodiscard]] Index cell_on(Index loop, Index side) const {
        const Index cell = mesh_cell[loop][side];
        return cell >= cell_begin && cell < cell_end ? cell - cell_begin : none;
    }
    [[nodiscard]] bool is_boundary(Index loop) const { return mesh_cell[loop][1] == none; }

    Index cell_begin = 0, cell_end = 0;
    std::vector<Index> edge;                     // by corner: local edge to the next corner
    std::vector<Index> vertices;                 // local vertex -> mesh vertex, ascending
    std::vector<std::array<Index, 2>> edge_ends; // local edge -> its local vertices, the lower first

private:
    [[nodiscard]] bool has_repeats() const;
    void remove_repeats();
    void check_sides() const;
    void number_vertices();
    void find_edges();
    Index edge_between(Index low, Index high); // creates the edge if it is new

    const FaceSource& source_;
    std::vector<Index> collapsed_;                          // vertices of loops that collapsed to a point
    LocalNumbers local_vertex_;                             // mesh vertex -> local vertex
    std::vector<Index> edge_head_, edge_next_;              // lists of edges by lower vertex, at most 64 edges each
    std::unordered_map<std::uint64_t, Index> crowded_edge_; // (lower, upper vertex) -> edge, if in no list
};

} // namespace ciel::detail
