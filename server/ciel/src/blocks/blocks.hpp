// The layout behind Topology, for the kernel's own files: the paper's half-edges (section 2.2, figure 3) without
// pointers. Consecutive cells are in a block, with 16-bit local ids. Nothing changes after the build, so any thread may
// read.
//
// The cells of one standard type in a block are a StandardSection. A cell stores its vertices, its edges and one
// reference per face; all else is the same for all cells of the type and is in StandardShape.
// All other cells of a block are its PolyhedralSection. Inner faces lie between two of these cells and are stored once.
// Tail faces have only one of these cells; their loops also run in the direction of the mesh's loop.
//
// Local half-edges are numbered section by section. In a standard cell, they have the order of its shape. In a
// PolyhedralSection, the half-edges of inner faces are 2 * corner + side; after them, tail faces have one half-edge per
// corner. Side 0 of a face is the owner's and runs along the stored loop; side 1 runs against it.
// An entry is a place where a vertex occurs: a corner of a standard cell or a corner of a stored loop.
#pragma once

#include "ciel/standard_shapes.hpp"
#include "ciel/topology.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace ciel {

// A HalfEdge is the number of its block, then its local number in the block.
[[nodiscard]] inline HalfEdge half_edge_in(Index block, Index local) {
    return static_cast<HalfEdge>(std::uint64_t{block} << 32 | local);
}
[[nodiscard]] inline Index block_of(HalfEdge h) { return static_cast<Index>(static_cast<std::uint64_t>(h) >> 32); }
[[nodiscard]] inline Index local_of(HalfEdge h) { return static_cast<Index>(h); }

struct StandardSection {
    static constexpr std::uint16_t no_mate = std::numeric_limits<std::uint16_t>::max();
    static constexpr Index cells_per_group = 8;

    const StandardShape* shape = nullptr;
    Index cells = 0;
    Index half_edge_begin = 0, entry_begin = 0; // first local half-edge, first entry
    std::vector<std::uint16_t> cell;            // local cells, ascending; empty means all cells of the block
    std::vector<std::uint16_t> vertex;          // shape->corners local vertices per cell
    std::vector<std::uint16_t> edge;            // shape->edges local edges per cell
    // By cell and face: the mate of the first half-edge of the face. If the mate is in a standard section of the block:
    // its local half-edge. Otherwise Block::standard_half_edges + an index into Block::twin_half_edge, or no_mate on
    // the boundary.
    std::vector<std::uint16_t> mate;
    std::vector<std::uint16_t> next_entry;  // by corner: next entry of the same vertex, or end_of_list
    std::vector<std::uint64_t> group_parts; // by group of cells: one bit per part of the vertices that it uses

    [[nodiscard]] Index count() const { return cells; }
    [[nodiscard]] Index group_count() const { return (cells + cells_per_group - 1) / cells_per_group; }
    [[nodiscard]] Index local_cell(Index i) const { return cell.empty() ? i : cell[i]; }
};

// Local: std::uint16_t, or std::uint32_t in a block of one giant cell.
template <class Local>
struct PolyhedralSection {
    static constexpr Local end_of_list = std::numeric_limits<Local>::max();
    static constexpr Index escape = 15, longest_search = 256;

    Index half_edge_begin = 0, entry_begin = 0; // first local half-edge, first entry
    Index inner_corners = 0;                    // corners below this are of inner faces (between two cells here)
    Index far_corner = 0;                       // corners from here on: tail faces whose owner is not in the section
    Index inner_faces = 0;                      // faces below this are inner; the others are tail faces
    Index twin_begin = 0;                       // index into Block::twin_half_edge of the first tail face
    std::vector<Local> cell;                    // local cells, ascending; empty means all cells of the block
    // By corner of a stored loop:
    std::vector<Local> vertex;     // origin of the half-edge on side 0, target on side 1
    std::vector<Local> edge;       // local edge from this corner to the next
    std::vector<Local> next_entry; // in the list of the corners with the same vertex: next entry, or end_of_list
    // Four bits per half-edge: index of the face with its mate, among the faces of the cell, modulo `escape`. The value
    // `escape` means that the mate is in mate_escapes. It is used where `mate` would search more than longest_search
    // corners or find another half-edge.
    std::vector<std::uint8_t> mate_face;
    std::vector<std::pair<Index, Index>> mate_escapes; // (half-edge, mate), sorted; half-edge ids may exceed Local
    // By face:
    std::vector<Local> face_begin;               // first corner of the face; one more at the end
    std::vector<std::array<Local, 2>> face_cell; // cell of the section by side; twice the same for a tail face
    std::vector<std::uint64_t> face_start;       // one bit per corner, set at the first corner of a face
    std::vector<Local> face_rank;                // number of faces that start before each word of face_start
    // By cell of the section:
    std::vector<Local> cell_face_begin; // first index in cell_face; one more at the end
    std::vector<Local> cell_face;       // 2 * face + side, in the order of the mesh's faces

    [[nodiscard]] Index count() const {
        return cell_face_begin.empty() ? 0 : static_cast<Index>(cell_face_begin.size() - 1);
    }
    [[nodiscard]] Index local_cell(Index i) const { return cell.empty() ? i : cell[i]; }
    [[nodiscard]] Index face_count() const {
        return face_begin.empty() ? 0 : static_cast<Index>(face_begin.size() - 1);
    }
    [[nodiscard]] Index corner(Index half_edge) const {
        return half_edge < 2 * inner_corners ? half_edge / 2 : half_edge - inner_corners;
    }
    [[nodiscard]] Index side(Index half_edge) const {
        return half_edge < 2 * inner_corners ? half_edge % 2 : Index{half_edge - inner_corners >= far_corner};
    }
    // `side_id` is ignored for tail faces, which have one half-edge per corner.
    [[nodiscard]] Index half_edge(Index corner_id, Index side_id) const {
        return corner_id < inner_corners ? 2 * corner_id + side_id : corner_id + inner_corners;
    }
    [[nodiscard]] Index face(Index corner_id) const {
        const std::uint64_t up_to = ~std::uint64_t{0} >> (63 - corner_id % 64);
        return Index{face_rank[corner_id / 64]} +
               static_cast<Index>(std::popcount(face_start[corner_id / 64] & up_to)) - 1;
    }
    [[nodiscard]] Index next_in_loop(Index corner_id, Index face_id) const {
        return corner_id + 1 == face_begin[face_id + 1] ? face_begin[face_id] : corner_id + 1;
    }
    [[nodiscard]] Index previous_in_loop(Index corner_id, Index face_id) const {
        return (corner_id == face_begin[face_id] ? face_begin[face_id + 1] : corner_id) - 1;
    }
    [[nodiscard]] std::span<const Local> faces_of(Index i) const {
        return std::span(cell_face).subspan(cell_face_begin[i], cell_face_begin[i + 1] - cell_face_begin[i]);
    }
    [[nodiscard]] Index origin(Index half_edge_id) const {
        const Index k = corner(half_edge_id);
        return vertex[side(half_edge_id) == 0 ? k : next_in_loop(k, face(k))];
    }
    [[nodiscard]] Index mate_bits(Index half_edge_id) const {
        return Index{mate_face[half_edge_id / 2]} >> 4 * (half_edge_id % 2) & 15U;
    }
    // Returns the half-edge of the same edge in the adjacent face of the cell. In a face that collapsed to a line, the
    // mate may be in the face itself.
    [[nodiscard]] Index mate(Index half_edge_id) const;
};

template <class Local>
struct BlockArrays {
    std::vector<Local> first_entry; // by local vertex: its first entry, or end_of_list
    // border_vertex: local vertices that other blocks have too, ascending. The blocks of such a vertex form a ring:
    // each leads to the next higher block, the last to the first. border_block: the next block in the ring, as an index
    // into Block::neighbour. border_place: index of the vertex in border_vertex of that block.
    std::vector<Local> border_vertex, border_block, border_place;
    std::vector<Local> twin_block; // by twin: its block as an index into Block::neighbour; end_of_list on the boundary
    PolyhedralSection<Local> polyhedra;
};

struct BlockVertex {
    Index block, vertex;
};

struct BorderVertex {
    Index block, place; // place: index in border_vertex of the block
};

struct Block {
    Index cell_begin = 0, cell_count = 0;
    Index half_edge_count = 0;
    Index standard_half_edges = 0;            // number of half-edges of standard cells, which come first
    Index edge_begin = 0, edge_count = 0;     // id of the first owned edge; number of local edges
    Index vertex_begin = 0, vertex_count = 0; // vertex_begin + local vertex is a "slot", unique in the mesh
    Index own_vertex_begin = 0;               // first mesh vertex that this block is the first to have
    std::vector<Index> ghost_vertex;          // mesh ids of the ghosts, which are the first local vertices
    std::vector<Index> ghost_edge;            // mesh-wide ids of the ghosts, which are the first local edges
    std::vector<Index> twin_half_edge;        // mates that are in other blocks or sections: local numbers there
    // Blocks that come next in the ring of a border vertex, and blocks of the twins, ascending. The block itself is one
    // of them if a twin is in another of its sections.
    std::vector<Index> neighbour;
    std::vector<StandardSection> standard;
    std::variant<BlockArrays<std::uint16_t>, BlockArrays<std::uint32_t>> arrays;

    [[nodiscard]] Index vertex(Index local) const {
        const auto ghosts = static_cast<Index>(ghost_vertex.size());
        return local < ghosts ? ghost_vertex[local] : own_vertex_begin + local - ghosts;
    }
    // Returns the number of consecutive local vertices that are one part. A block has at most 64 parts.
    [[nodiscard]] Index vertices_per_part() const { return 8 * std::max<Index>(1, (vertex_count + 511) / 512); }
    [[nodiscard]] Index edge_id(Index local) const {
        const auto ghosts = static_cast<Index>(ghost_edge.size());
        return local < ghosts ? ghost_edge[local] : edge_begin + local - ghosts;
    }
    // Return the standard section with a local half-edge or an entry; null if the PolyhedralSection has it.
    [[nodiscard]] const StandardSection* section_of_half_edge(Index h) const;
    [[nodiscard]] const StandardSection* section_of_entry(Index entry) const;
    [[nodiscard]] Index border_place_of(Index local_vertex) const; // index in border_vertex; none if not shared
    [[nodiscard]] HalfEdge twin(Index i) const;                    // no_half_edge on the boundary
    // Returns the first entry of the vertex that is at least `begin`, or end_of_list, which is above all entries.
    [[nodiscard]] Index first_entry_from(Index local_vertex, Index begin) const;
    // Calls f with the BlockArrays, whose ids have 16 or 32 bits.
    template <class F>
    decltype(auto) with(F&& f) const {
        return std::visit(std::forward<F>(f), arrays);
    }
};

struct Topology::Blocks {
    std::vector<Block> block;
    std::vector<Index> edge_begin; // block -> id of its first owned edge; one more at the end
    TopologyCounts counts;

    [[nodiscard]] Index block_of_cell(Index cell) const;
    // Returns the vertex in the block that owns it, or {none, none} if no cell has it.
    [[nodiscard]] BlockVertex first_with(Index vertex) const;
    [[nodiscard]] BorderVertex next_in_ring(BorderVertex at) const {
        const Block& here = block[at.block];
        return here.with([&](const auto& all) {
            return BorderVertex{here.neighbour[all.border_block[at.place]], all.border_place[at.place]};
        });
    }
    [[nodiscard]] Index vertex_at(BorderVertex at) const {
        return block[at.block].with([&](const auto& all) { return Index{all.border_vertex[at.place]}; });
    }
    // Returns the first half-edge in the block that leaves the vertex; no_half_edge if only collapsed faces have the
    // vertex.
    [[nodiscard]] HalfEdge first_at(BlockVertex at) const;
    // Returns the first half-edge that leaves the vertex at `entry`. If `entry` is end_of_list, continues in the next
    // block of the ring of the vertex.
    [[nodiscard]] HalfEdge first_after(Index block, Index entry, Index local_vertex) const;
    // Returns the first half-edge that leaves the vertex in the blocks after at.block around its ring, at.block itself
    // last.
    [[nodiscard]] HalfEdge first_after_block(BlockVertex at) const;
    // Returns the half-edge that is `steps` before h in its face. `face_size`: number of half-edges of the face.
    [[nodiscard]] HalfEdge turn_back(HalfEdge h, Index steps, Index face_size) const;
};

// Returns the local half-edge that is `steps` after the given one in its face.
[[nodiscard]] Index turn(const Block& block, Index local_half_edge, Index steps);

template <class Local>
Index PolyhedralSection<Local>::mate(Index h) const {
    const Index bits = mate_bits(h);
    if (bits == escape) {
        std::size_t low = 0, high = mate_escapes.size();
        while (low + 1 < high) {
            const std::size_t middle = (low + high) / 2;
            (mate_escapes[middle].first <= h ? low : high) = middle;
        }
        return mate_escapes[low].second;
    }
    const Index k = corner(h), own = face(k);
    const std::span<const Local> faces = faces_of(face_cell[own][side(h)]);
    Index left = longest_search; // corners; when none are left, fill_polyhedra stores an escape
    for (Index i = bits; i < faces.size() && left > 0; i += escape) {
        const Index other = faces[i] / 2;
        if (other == own) continue;
        const Index end = std::min(Index{face_begin[other + 1]}, face_begin[other] + left);
        for (Index at = face_begin[other]; at < end; ++at)
            if (edge[at] == edge[k]) return half_edge(at, faces[i] % 2);
        left -= end - face_begin[other];
    }
    return none;
}

} // namespace ciel
