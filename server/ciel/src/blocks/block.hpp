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
#include <array>
#include <bit>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace ciel {

// The arrays of a block are owned while it is built, and lie in its records afterwards (block_records.hpp).
template <class T>
using Owned = std::vector<T>;
template <class T>
using Viewed = std::span<const T>;

// The ghosts of a block: vertices or edges that blocks before it own. A record names a ghost by an index into its list
// of neighbors, and by the ghost's index among what that neighbor owns.
struct Ghosts {
    std::span<const std::array<std::uint16_t, 2>> narrow; // (neighbor, index); empty if an index needs 32 bits
    std::span<const std::array<std::uint32_t, 2>> wide;
    std::vector<Index> begin; // by neighbor: id of the first that it owns

    [[nodiscard]] std::size_t size() const { return narrow.size() + wide.size(); }
    // Returns the mesh-wide id.
    [[nodiscard]] Index operator[](std::size_t i) const {
        if (wide.empty()) return begin[narrow[i][0]] + narrow[i][1];
        return begin[wide[i][0]] + wide[i][1];
    }
    // Calls f(mesh-wide id) for each ghost. Faster than the operator.
    template <class F>
    void for_each(F&& f) const {
        for (const auto [neighbour, index] : narrow) f(begin[neighbour] + index);
        for (const auto [neighbour, index] : wide) f(begin[neighbour] + index);
    }
};

// The types of standard cells, in the order of their sections.
inline constexpr std::array<CellType, 4> standard_types{CellType::tetrahedron, CellType::hexahedron, CellType::wedge,
                                                        CellType::pyramid};
[[nodiscard]] inline std::size_t place_of_type(CellType type) {
    return static_cast<std::size_t>(std::ranges::find(standard_types, type) - standard_types.begin());
}

template <template <class> class Array>
struct StandardSectionOf {
    static constexpr Index cells_per_group = 8;

    const StandardShape* shape = nullptr;
    Index cells = 0;
    Index half_edge_begin = 0, entry_begin = 0; // first local half-edge, first entry
    Array<std::uint16_t> cell;                  // local cells, ascending; empty means all cells of the block
    Array<std::uint16_t> vertex;                // shape->corners local vertices per cell
    Array<std::uint16_t> edge;                  // shape->edges local edges per cell
    Array<std::uint64_t> group_parts;           // by group of cells: one bit per part of the vertices that it uses

    [[nodiscard]] Index count() const { return cells; }
    [[nodiscard]] Index group_count() const { return (cells + cells_per_group - 1) / cells_per_group; }
    [[nodiscard]] Index local_cell(Index i) const { return cell.empty() ? i : cell[i]; }
};
using StandardSection = StandardSectionOf<Viewed>;

// Local: std::uint16_t, or std::uint32_t in a block of one giant cell.
template <class Local, template <class> class Array = Viewed>
struct PolyhedralSection {
    Index half_edge_begin = 0, entry_begin = 0; // first local half-edge, first entry
    Index inner_corners = 0;                    // corners below this are of inner faces (between two cells here)
    Index far_corner = 0;                       // corners from here on: tail faces whose owner is not in the section
    Index inner_faces = 0;                      // faces below this are inner; the others are tail faces
    Array<Local> cell;                          // local cells, ascending; empty means all cells of the block
    // By corner of a stored loop:
    Array<Local> vertex; // origin of the half-edge on side 0, target on side 1
    Array<Local> edge;   // local edge from this corner to the next
    // By face:
    Array<Local> face_begin;               // first corner of the face; one more at the end
    Array<std::array<Local, 2>> face_cell; // cell of the section by side; twice the same for a tail face
    Array<std::uint64_t> face_start;       // one bit per corner, set at the first corner of a face
    Array<Local> face_rank;                // number of faces that start before each word of face_start
    // By cell of the section:
    Array<Local> cell_face_begin; // first index in cell_face; one more at the end
    Array<Local> cell_face;       // 2 * face + side, in the order of the mesh's faces

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

template <template <class> class Array>
struct BlockOf {
    Index cell_begin = 0, cell_count = 0;
    Index half_edge_count = 0;
    Index standard_half_edges = 0;            // number of half-edges of standard cells, which come first
    Index edge_begin = 0, edge_count = 0;     // id of the first owned edge; number of local edges
    Index vertex_begin = 0, vertex_count = 0; // vertex_begin + local vertex is a "slot", unique in the mesh
    Index own_vertex_begin = 0;               // first mesh vertex that this block is the first to have
    // Mesh-wide ids of the ghosts, which are the first local ids, ascending.
    std::conditional_t<std::is_same_v<Array<Index>, Owned<Index>>, std::vector<Index>, Ghosts> ghost_vertex, ghost_edge;
    std::vector<StandardSectionOf<Array>> standard;
    std::variant<PolyhedralSection<std::uint16_t, Array>, PolyhedralSection<std::uint32_t, Array>> polyhedra;

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

using Block = BlockOf<Viewed>;

// Returns the local half-edge that is `steps` after the given one in its face.
template <template <class> class Array>
[[nodiscard]] Index turn(const BlockOf<Array>& block, Index local_half_edge, Index steps) {
    if (const std::size_t s = block.section_of_half_edge(local_half_edge); s < block.standard.size()) {
        const auto& section = block.standard[s];
        const StandardShape& shape = *section.shape;
        const Index of_cell = (local_half_edge - section.half_edge_begin) % shape.half_edges;
        const Index begin = shape.face_begin[shape.face[of_cell]], n = shape.face_size(shape.face[of_cell]);
        return local_half_edge - of_cell + begin + (of_cell - begin + steps) % n;
    }
    return block.with([&](const auto& polyhedra) {
        const Index local = local_half_edge - polyhedra.half_edge_begin;
        const Index corner = polyhedra.corner(local), side = polyhedra.side(local), face = polyhedra.face(corner);
        const Index begin = polyhedra.face_begin[face], n = polyhedra.face_begin[face + 1] - begin;
        const Index forward = side == 0 ? steps % n : n - steps % n;
        return polyhedra.half_edge_begin + polyhedra.half_edge(begin + (corner - begin + forward) % n, side);
    });
}

} // namespace ciel
