// The layout behind Topology, for the kernel's own files: the paper's half-edges (section 2.2, figure 3) without
// pointers, consecutive cells in blocks with local ids of 16 bits. Owns its arrays; nothing changes after the build, so
// any thread may read.
//
// A block's cells of one standard type make a StandardSection: what half-edges of a type have in common is in its
// StandardShape, a cell stores its vertices, its edges and one reference per face. All other cells make the block's
// PolyhedralSection: a face between two of them is stored once; a face with only one of them on it in the tail, with
// its loop in the same direction.
//
// Local half-edges are numbered section by section: a standard cell's in the order of its shape; of the polyhedra
// 2 * corner + side for inner faces, then one per corner of the tail. Side 0 runs along the stored loop (the owner's
// side), side 1 against it. Entries are the places where a vertex occurs: a standard cell's corners, a stored loop's.
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

struct StandardSection {
    static constexpr std::uint16_t no_mate = std::numeric_limits<std::uint16_t>::max();
    static constexpr Index cells_per_group = 8;

    const StandardShape* shape = nullptr;
    Index cells = 0;
    Index half_edge_begin = 0, entry_begin = 0; // local
    std::vector<std::uint16_t> cell;            // local cells, ascending; empty when all of the block's are here
    std::vector<std::uint16_t> vertex;          // corners per cell
    std::vector<std::uint16_t> edge;            // edges per cell
    // Per face: the half-edge across its first one, in a standard section too; or the half-edges of those sections + an
    // index into Block::twin; or no_mate.
    std::vector<std::uint16_t> mate;
    std::vector<std::uint16_t> next_entry; // per corner: next entry of the same vertex, or end_of_list
    std::vector<std::uint64_t>
        group_parts; // per group: a bit for each part of the block's vertices that it has some of

    [[nodiscard]] Index count() const { return cells; }
    [[nodiscard]] Index group_count() const { return (cells + cells_per_group - 1) / cells_per_group; }
    [[nodiscard]] Index local_cell(Index i) const { return cell.empty() ? i : cell[i]; }
};

// 32 bits for a giant cell, which has a block of its own.
template <class Local>
struct PolyhedralSection {
    static constexpr Local end_of_list = std::numeric_limits<Local>::max();
    static constexpr Index escape = 15, longest_search = 256;

    Index half_edge_begin = 0, entry_begin = 0; // local
    Index inner_corners = 0;                    // corners below this belong to inner faces
    Index far_corner = 0;                       // corners from here on belong to tail faces whose owner is another cell
    Index inner_faces = 0;                      // faces below this are inner
    Index twin_begin = 0;                       // + tail face: index into Block::twin
    std::vector<Local> cell;                    // local cells, ascending; empty when all of the block's are here
    // Per corner of a stored loop.
    std::vector<Local> vertex;     // origin of side 0, target of side 1
    std::vector<Local> edge;       // from this corner to the next
    std::vector<Local> next_entry; // next entry of the same vertex, or end_of_list
    // Four bits per half-edge of the section: which of its cell's faces has its mate, modulo `escape`; or `escape`, and
    // then mate_escapes tells the mate: also where a search would be longer than `longest_search` corners, as in a cell
    // of thousands of faces or with a face of thousands of corners. (Half-edges may be more than Local counts: two of
    // them share a corner.)
    std::vector<std::uint8_t> mate_face;
    std::vector<std::pair<Index, Index>> mate_escapes; // sorted
    // Per face.
    std::vector<Local> face_begin;               // first corner; one more at the end
    std::vector<std::array<Local, 2>> face_cell; // by side; tail faces have the same one twice
    std::vector<std::uint64_t> face_start;       // a bit per corner
    std::vector<Local> face_rank;                // faces that start before each of the words above
    // Per cell of the section, numbered from 0 here.
    std::vector<Local> cell_face_begin; // one more at the end
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
    // `side` matters for inner faces only.
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
    // The half-edge of the same edge and cell, in another face but where a face collapsed to a line.
    [[nodiscard]] Index mate(Index half_edge_id) const;
};

template <class Local>
struct BlockArrays {
    std::vector<Local> first_entry; // per local vertex
    // The vertices that other blocks share, ascending, and for each the next block that has it: around the ring of
    // those blocks, ascending and then round again. As an index into Block::neighbour, and the place in that block's
    // border.
    std::vector<Local> border_vertex, border_block, border_place;
    PolyhedralSection<Local> polyhedra;
};

struct BlockVertex {
    Index block, vertex;
};

struct BorderVertex {
    Index block, place; // in its border_vertex
};

struct Block {
    Index cell_begin = 0, cell_count = 0;
    Index half_edge_begin = 0, half_edge_count = 0; // prefix of half-edge ids
    Index standard_half_edges = 0;                  // the first of them
    Index edge_begin = 0, edge_count = 0;           // id of the first edge the block owns; all its local edges
    Index vertex_begin = 0, vertex_count = 0;       // prefix of local vertices: + local vertex is a "slot"
    Index own_vertex_begin = 0;                     // first mesh vertex that the block owns: is the first to have
    std::vector<Index> ghost_vertex; // mesh ids of the first local vertices, ascending; its own come after them
    std::vector<Index> ghost_edge;   // mesh-wide ids of the first local edges, ascending; its own come after them
    std::vector<HalfEdge> twin;      // half-edges in other blocks or sections, or none
    std::vector<Index> neighbour;    // blocks that share vertices, ascending
    std::vector<StandardSection> standard;
    std::variant<BlockArrays<std::uint16_t>, BlockArrays<std::uint32_t>> arrays;

    [[nodiscard]] Index vertex(Index local) const {
        const auto ghosts = static_cast<Index>(ghost_vertex.size());
        return local < ghosts ? ghost_vertex[local] : own_vertex_begin + local - ghosts;
    }
    // So many consecutive local vertices are a part, of which there are at most 64.
    [[nodiscard]] Index vertices_per_part() const { return 8 * std::max<Index>(1, (vertex_count + 511) / 512); }
    [[nodiscard]] Index edge_id(Index local) const {
        const auto ghosts = static_cast<Index>(ghost_edge.size());
        return local < ghosts ? ghost_edge[local] : edge_begin + local - ghosts;
    }
    // The standard section that a local half-edge or an entry is in; null for the polyhedra's.
    [[nodiscard]] const StandardSection* section_of_half_edge(Index h) const;
    [[nodiscard]] const StandardSection* section_of_entry(Index entry) const;
    [[nodiscard]] Index border_place_of(Index local_vertex) const; // none inside the block
    // The first of a vertex's entries that is not below `begin`, or the end of the list, which is above all entries.
    [[nodiscard]] Index first_entry_from(Index local_vertex, Index begin) const;
    // Calls f with the arrays at their width.
    template <class F>
    decltype(auto) with(F&& f) const {
        return std::visit(std::forward<F>(f), arrays);
    }
};

struct Topology::Blocks {
    std::vector<Block> block;
    std::vector<Index> block_at;   // half-edge id / 4096 -> block of the first half-edge there
    std::vector<Index> edge_begin; // block -> its first edge id; one more at the end
    TopologyCounts counts;

    [[nodiscard]] Index block_of(HalfEdge h) const {
        Index b = block_at[h >> 12];
        while (b + 1 < block.size() && block[b + 1].half_edge_begin <= h) ++b;
        return b;
    }
    [[nodiscard]] Index block_of_cell(Index cell) const;
    [[nodiscard]] BlockVertex first_with(Index vertex) const; // {none, none} for a vertex of no cell
    [[nodiscard]] BorderVertex next_in_ring(BorderVertex at) const {
        const Block& here = block[at.block];
        return here.with([&](const auto& all) {
            return BorderVertex{here.neighbour[all.border_block[at.place]], all.border_place[at.place]};
        });
    }
    [[nodiscard]] Index vertex_at(BorderVertex at) const {
        return block[at.block].with([&](const auto& all) { return Index{all.border_vertex[at.place]}; });
    }
    // A half-edge that leaves a vertex: the first in a block, none where only collapsed faces have the vertex;
    [[nodiscard]] HalfEdge first_at(BlockVertex at) const;
    // the first at an entry, or in the next block of the ring where `entry` is the end of the list;
    [[nodiscard]] HalfEdge first_after(Index block, Index entry, Index local_vertex) const;
    // the first in the blocks that follow around the ring, up to the same one.
    [[nodiscard]] HalfEdge first_after_block(BlockVertex at) const;
    // `steps` back around the face, which has `face_size` half-edges.
    [[nodiscard]] HalfEdge turn_back(HalfEdge h, Index steps, Index face_size) const;
};

// The half-edge `steps` further around its face.
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
    Index left = longest_search; // for the one who builds: a mate that is stored is found before
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
