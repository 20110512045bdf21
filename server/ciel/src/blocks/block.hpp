// The cells of a block: all that a surface, a slice and a picture need of the paper's half-edge structure (section 2.2,
// figure 3). Without pointers; consecutive cells are in a block, with 16-bit local ids. Nothing changes after the
// build, so any thread may read.
//
// The cells of one standard type in a block are a StandardSection. A cell stores its vertices and its edges; all else
// is the same for all cells of the type and is in StandardShape. All other cells of a block are its PolyhedralSection.
// Inner faces lie between two of these cells and are stored once. Tail faces have only one of these cells; their loops
// also run in the direction of the mesh's loop.
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
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace ciel {

struct StandardSection {
    static constexpr Index cells_per_group = 8;

    const StandardShape* shape = nullptr;
    Index cells = 0;
    Index half_edge_begin = 0, entry_begin = 0; // first local half-edge, first entry
    std::vector<std::uint16_t> cell;            // local cells, ascending; empty means all cells of the block
    std::vector<std::uint16_t> vertex;          // shape->corners local vertices per cell
    std::vector<std::uint16_t> edge;            // shape->edges local edges per cell
    std::vector<std::uint64_t> group_parts;     // by group of cells: one bit per part of the vertices that it uses

    [[nodiscard]] Index count() const { return cells; }
    [[nodiscard]] Index group_count() const { return (cells + cells_per_group - 1) / cells_per_group; }
    [[nodiscard]] Index local_cell(Index i) const { return cell.empty() ? i : cell[i]; }
};

// Local: std::uint16_t, or std::uint32_t in a block of one giant cell.
template <class Local>
struct PolyhedralSection {
    Index half_edge_begin = 0, entry_begin = 0; // first local half-edge, first entry
    Index inner_corners = 0;                    // corners below this are of inner faces (between two cells here)
    Index far_corner = 0;                       // corners from here on: tail faces whose owner is not in the section
    Index inner_faces = 0;                      // faces below this are inner; the others are tail faces
    std::vector<Local> cell;                    // local cells, ascending; empty means all cells of the block
    // By corner of a stored loop:
    std::vector<Local> vertex; // origin of the half-edge on side 0, target on side 1
    std::vector<Local> edge;   // local edge from this corner to the next
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
};

struct Block {
    Index cell_begin = 0, cell_count = 0;
    Index half_edge_count = 0;
    Index standard_half_edges = 0;               // number of half-edges of standard cells, which come first
    Index edge_begin = 0, edge_count = 0;        // id of the first owned edge; number of local edges
    Index vertex_begin = 0, vertex_count = 0;    // vertex_begin + local vertex is a "slot", unique in the mesh
    Index own_vertex_begin = 0;                  // first mesh vertex that this block is the first to have
    std::vector<Index> ghost_vertex, ghost_edge; // mesh-wide ids of the ghosts, which are the first local ids
    std::vector<StandardSection> standard;
    std::variant<PolyhedralSection<std::uint16_t>, PolyhedralSection<std::uint32_t>> polyhedra;

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
    // Return the index in `standard` of the section with a local half-edge or an entry; standard.size() if the
    // PolyhedralSection has it.
    [[nodiscard]] std::size_t section_of_half_edge(Index h) const {
        std::size_t s = 0;
        while (s < standard.size() &&
               h >= standard[s].half_edge_begin + standard[s].count() * standard[s].shape->half_edges)
            ++s;
        return s;
    }
    [[nodiscard]] std::size_t section_of_entry(Index entry) const {
        std::size_t s = 0;
        while (s < standard.size() && entry >= standard[s].entry_begin + standard[s].vertex.size()) ++s;
        return s;
    }
    // Calls f with the PolyhedralSection, whose ids have 16 or 32 bits.
    template <class F>
    decltype(auto) with(F&& f) const {
        return std::visit(std::forward<F>(f), polyhedra);
    }
};

// Returns the local half-edge that is `steps` after the given one in its face.
[[nodiscard]] Index turn(const Block& block, Index local_half_edge, Index steps);

} // namespace ciel
