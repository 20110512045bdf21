// The layout behind Topology, for the kernel's own files: consecutive cells in blocks with local ids.
//
// A face between two cells of one block is stored once; a face to another block or to the outside is stored in the tail
// of each block that has a side of it, with its loop in the same direction. Local half-edges: 2 * corner + side of the
// inner faces, then one per corner of the tail. Side 0 runs along the stored loop (the owner's side), side 1 against
// it.
#pragma once

#include "ciel/topology.hpp"

#include <limits>
#include <variant>
#include <vector>

namespace ciel {

// 16 bits where the block's half-edges fit, 32 bits for the rare giant cell.
template <class Local>
struct BlockArrays {
    static constexpr Local end_of_list = std::numeric_limits<Local>::max();

    // Per corner of a stored loop.
    std::vector<Local> vertex;      // local vertex: origin of side 0, target of side 1
    std::vector<Local> face;        // local face
    std::vector<Local> edge;        // local edge from this corner to the next
    std::vector<Local> next_corner; // next corner at the same vertex, or end_of_list
    // Per local half-edge.
    std::vector<Local> mate_face;
    // Per local vertex: first corner at it.
    std::vector<Local> first_corner;
    // Per local edge: its local ends, edge_low < edge_high. In the order of mesh-wide ids: first the ghosts, which
    // earlier blocks own, then the block's own.
    std::vector<Local> edge_low, edge_high;
    // Per cell (Block::cell_face_begin): 2 * local face + side, in the order of the mesh's faces.
    std::vector<Local> cell_face;
    // Per local face: its cell on the stored side(s); inner faces have both, tail faces the same one twice.
    std::vector<std::array<Local, 2>> face_cell;
    // Vertices that other blocks share, ascending; Block::border_next goes with them.
    std::vector<Local> border_vertex;
};

struct BlockVertex {
    Index block, vertex;
};

struct Block {
    Index cell_begin = 0, cell_count = 0;
    Index half_edge_begin = 0;          // prefix of half-edge ids
    Index edge_begin = 0;               // id of the first edge the block owns
    Index inner_corners = 0;            // corners below this belong to inner faces
    Index far_corner = 0;               // corners from here on belong to tail faces whose owner is in another block
    Index inner_faces = 0;              // local faces below this are inner
    Index vertex_begin = 0;             // prefix of local vertices; + local vertex: a "slot"
    std::vector<Index> vertex;          // local -> mesh vertex, ascending
    std::vector<Index> face_begin;      // local face -> first corner; one more at the end
    std::vector<Index> cell_face_begin; // local cell -> first of its cell_face; one more at the end
    std::vector<Index> ghost_edge;      // mesh-wide ids of the first local edges
    std::vector<HalfEdge> tail_twin;    // tail face -> half-edge of the other side at its first corner, or none
    std::vector<Index> border_next; // slots: the ring of a vertex through its blocks, ascending and then round again
    std::variant<BlockArrays<std::uint16_t>, BlockArrays<std::uint32_t>> arrays;

    [[nodiscard]] Index corner(Index local_half_edge) const {
        return local_half_edge < 2 * inner_corners ? local_half_edge / 2 : local_half_edge - inner_corners;
    }
    [[nodiscard]] Index side(Index local_half_edge) const {
        return local_half_edge < 2 * inner_corners ? local_half_edge % 2
                                                   : Index{local_half_edge - inner_corners >= far_corner};
    }
    // `side` matters for inner faces only.
    [[nodiscard]] Index half_edge(Index corner_id, Index side_id) const {
        return corner_id < inner_corners ? 2 * corner_id + side_id : corner_id + inner_corners;
    }
    [[nodiscard]] Index next_in_loop(Index corner_id, Index face) const {
        return corner_id + 1 == face_begin[face + 1] ? face_begin[face] : corner_id + 1;
    }
    [[nodiscard]] Index previous_in_loop(Index corner_id, Index face) const {
        return (corner_id == face_begin[face] ? face_begin[face + 1] : corner_id) - 1;
    }
    [[nodiscard]] Index edge_id(Index local_edge) const {
        const auto ghosts = static_cast<Index>(ghost_edge.size());
        return local_edge < ghosts ? ghost_edge[local_edge] : edge_begin + local_edge - ghosts;
    }
    // Calls f with the arrays at their width.
    template <class F>
    decltype(auto) with(F&& f) const {
        return std::visit(std::forward<F>(f), arrays);
    }
};

struct Topology::Blocks {
    std::vector<Block> block;
    std::vector<Index> first_slot; // mesh vertex -> its slot in the first block that has it, or none
    std::vector<Index> block_at;   // half-edge id / 4096 -> block of the first half-edge there
    std::vector<Index> edge_begin; // block -> its first edge id; one more at the end
    TopologyCounts counts;

    [[nodiscard]] Index block_of(HalfEdge h) const {
        Index b = block_at[h >> 12];
        while (b + 1 < block.size() && block[b + 1].half_edge_begin <= h) ++b;
        return b;
    }
    [[nodiscard]] Index block_of_cell(Index cell) const;
    [[nodiscard]] BlockVertex at_slot(Index slot) const;
    [[nodiscard]] BlockVertex next_in_ring(BlockVertex at) const;
    // Cells around a vertex, ascending.
    void cells_around(Index vertex, std::vector<Index>& cells) const;
};

} // namespace ciel
