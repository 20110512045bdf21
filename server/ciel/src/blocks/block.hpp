// The cells of a block. Surfaces, slices and pictures need only this part of the paper's half-edge structure (section
// 2.2, figure 3). A block has consecutive cells of the mesh. Its elements refer to each other by local ids, not by
// pointers. The ids have 16 bits, except in a block of one giant cell. Any thread may read a block.
//
// The cells of one standard type form a StandardSection. It stores the vertices and the edges of each cell; all other
// data are in StandardShape. All other cells of a block form its PolyhedralSection. It stores each face as a loop of
// vertices, in the direction of the face's loop in the mesh. An inner face lies between two cells of the section and is
// stored once. A tail face has only one cell in the section.
//
// Local half-edges are numbered section by section. In a standard cell, they have the order of its shape. In a
// PolyhedralSection, an inner face has the half-edges 2 * corner + side. The half-edges of tail faces follow, one per
// corner. Side 0 belongs to the owner cell and runs along the stored loop; side 1 belongs to the neighbor cell and runs
// against the loop. An entry is one occurrence of a vertex: a corner of a standard cell or a corner of a stored loop.
//
// The bytes of a record may change after they were checked, for example when another process writes a mapped file
// (RecordSource). Comments call such a record "changed". A change affects the elements of viewed arrays, but not the
// sizes of the arrays and not other members. Therefore an element may be used as an index in three cases only: into an
// array of a record, into a scratch array with room for every 16-bit number (local_ids), or after a comparison with the
// size of the array. Ids of 32 bits do not change, because topology.cpp copies the records that have them.
#pragma once

#include "blocks/record.hpp"
#include "ciel/topology.hpp"
#include "mesh/standard_shapes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace ciel::detail {

// Number of different 16-bit local ids.
inline constexpr std::size_t local_ids = std::size_t{1} << 16;

// While a block is built, it owns its arrays. Afterwards its arrays are views of its records (block_records.hpp).
template <class T>
using Owned = std::vector<T>;
template <class T>
using Viewed = std::span<const T>;

// The ghosts of a block: vertices or edges that the block has, but that an earlier block owns. `narrow` or `wide` has a
// pair for each ghost: the index of the owner block in the record's list of neighbor blocks, and the index of the ghost
// among the vertices or edges that the owner owns.
struct Ghosts {
    std::span<const std::array<std::uint16_t, 2>> narrow; // pairs (neighbor, index); empty if an index needs 32 bits
    std::span<const std::array<std::uint32_t, 2>> wide;
    std::vector<Index> begin; // by neighbor: mesh-wide id of the first vertex or edge that it owns
    Index last = 0;           // greatest vertex or edge id of the mesh

    [[nodiscard]] std::size_t size() const { return narrow.size() + wide.size(); }
    [[nodiscard]] Index operator[](std::size_t i) const {
        if (wide.empty()) return id(read_once(narrow[i][0]), read_once(narrow[i][1]));
        return id(read_once(wide[i][0]), read_once(wide[i][1]));
    }
    // Calls f(mesh-wide id) for each ghost. Faster than operator[].
    template <class F>
    void for_each(F&& f) const {
        for (const auto& [neighbour, index] : narrow) f(id(read_once(neighbour), read_once(index)));
        for (const auto& [neighbour, index] : wide) f(id(read_once(neighbour), read_once(index)));
    }

private:
    // Returns an id that exists in the mesh, even if the record has changed.
    [[nodiscard]] Index id(Index neighbour, Index index) const {
        return std::min(begin[std::min(neighbour, static_cast<Index>(begin.size() - 1))] + index, last);
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
    // one word per group of 8 cells: bit p is set if a cell of the group has a vertex in part p (vertices_per_part)
    Array<std::uint64_t> group_parts;

    [[nodiscard]] Index count() const { return cells; }
    [[nodiscard]] Index group_count() const { return (cells + cells_per_group - 1) / cells_per_group; }
    [[nodiscard]] Index local_cell(Index i) const { return cell.empty() ? i : cell[i]; }
};
using StandardSection = StandardSectionOf<Viewed>;

// Local: std::uint16_t, or std::uint32_t in a block of one giant cell.
template <class Local, template <class> class Array = Viewed>
struct PolyhedralSection {
    Index half_edge_begin = 0, entry_begin = 0; // first local half-edge, first entry
    Index inner_corners = 0;                    // number of corners of inner faces, which come first
    Index far_corner = 0;  // first corner of tail faces whose owner is not in the section; they come last
    Index inner_faces = 0; // number of inner faces, which come first; all others are tail faces
    Array<Local> cell;     // local cells, ascending; empty means all cells of the block
    // By corner of a stored loop:
    Array<Local> vertex; // origin of the corner's half-edge on side 0, target of its half-edge on side 1
    Array<Local> edge;   // local edge from this corner to the next
    // By face:
    Array<Local> face_begin;               // first corner of each face, then the number of corners
    Array<std::array<Local, 2>> face_cell; // [side]: index of the cell in the section; a tail face has its cell twice
    Array<std::uint64_t> face_start;       // one bit per corner, set at the first corner of a face
    Array<Local> face_rank;                // number of faces that start before each word of face_start
    // For each word of face_start, that is for 64 corners: bit p is set if a corner has a vertex in part p
    // (vertices_per_part). Empty if an earlier version of CIEL wrote the record.
    Array<std::uint64_t> corner_parts;
    // By cell of the section:
    Array<Local> cell_face_begin; // first index in cell_face of each cell, then the size of cell_face
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
    // Returns the face with the corner. If the record has changed, the result may be wrong, but does not wrap around
    // below 0. The same holds for previous_in_loop.
    [[nodiscard]] Index face(Index corner_id) const {
        const std::uint64_t up_to = ~std::uint64_t{0} >> (63 - corner_id % 64);
        const Index begun = Index{read_once(face_rank[corner_id / 64])} +
                            static_cast<Index>(std::popcount(read_once(face_start[corner_id / 64]) & up_to));
        return begun - Index{begun != 0};
    }
    // The corners of a face. `end` is never below `begin`, even if the record has changed.
    struct Loop {
        Index begin, end;
        [[nodiscard]] Index size() const { return end - begin; }
        [[nodiscard]] bool has(Index corner) const { return corner >= begin && corner < end; }
        [[nodiscard]] Index next(Index corner) const { return corner + 1 == end ? begin : corner + 1; }
        [[nodiscard]] Index previous(Index corner) const { return (corner == begin ? end : corner) - 1; }
    };
    [[nodiscard]] Loop loop(Index face_id) const {
        const Index begin = read_once(face_begin[face_id]), end = read_once(face_begin[face_id + 1]);
        return {begin, std::max(begin, end)};
    }
    [[nodiscard]] Index next_in_loop(Index corner_id, Index face_id) const {
        return corner_id + 1 == face_begin[face_id + 1] ? face_begin[face_id] : corner_id + 1;
    }
    [[nodiscard]] Index previous_in_loop(Index corner_id, Index face_id) const {
        const Index after = corner_id == face_begin[face_id] ? read_once(face_begin[face_id + 1]) : corner_id;
        return after - Index{after != 0};
    }
    [[nodiscard]] std::span<const Local> faces_of(Index i) const {
        const Index begin = read_once(cell_face_begin[i]), end = read_once(cell_face_begin[i + 1]);
        return {cell_face.data() + begin, std::max(begin, end) - begin};
    }
    // Calls f(face, corner), face by face. Ends even if the record changes, because the corner never decreases.
    template <class F>
    void for_corners(F&& f) const {
        for (Index face_id = 0, k = 0, faces = face_count(); face_id < faces; ++face_id)
            for (const Index end = read_once(face_begin[face_id + 1]); k < end; ++k) f(face_id, k);
    }
    // Calls f(index of the cell in the section, element of cell_face), cell by cell. Ends even if the record changes,
    // because `at` never decreases.
    template <class F>
    void for_cell_faces(F&& f) const {
        for (Index i = 0, at = 0, cells = count(); i < cells; ++i)
            for (const Index end = read_once(cell_face_begin[i + 1]); at < end; ++at)
                f(i, Index{read_once(cell_face[at])});
    }
    [[nodiscard]] Index half_edge_count() const { return static_cast<Index>(vertex.size()) + inner_corners; }
    [[nodiscard]] Index origin(Index half_edge_id) const {
        const Index k = corner(half_edge_id);
        return vertex[side(half_edge_id) == 0 ? k : next_in_loop(k, face(k))];
    }
};

template <template <class> class Array>
struct BlockOf {
    Index cell_begin = 0, cell_count = 0;
    Index half_edge_count = 0;
    Index standard_half_edges = 0;              // number of half-edges of standard cells, which come first
    Index edge_begin = 0, edge_count = 0;       // mesh-wide id of the first owned edge; number of local edges
    Index vertex_begin = 0, vertex_count = 0;   // vertex_begin + local vertex is a "slot", unique in the mesh
    Index own_vertex_begin = 0;                 // mesh-wide id of the first owned vertex
    Index last_vertex = none, last_edge = none; // greatest ids of the mesh; set only in a view
    // Mesh-wide ids, ascending. Ghost i has the local id i; the local ids of owned vertices or edges follow.
    std::conditional_t<std::is_same_v<Array<Index>, Owned<Index>>, std::vector<Index>, Ghosts> ghost_vertex, ghost_edge;
    std::vector<StandardSectionOf<Array>> standard;
    std::variant<PolyhedralSection<std::uint16_t, Array>, PolyhedralSection<std::uint32_t, Array>> polyhedra;
    RecordBytes copied; // copy of a record with 32-bit ids from a source that is not trusted; else empty

    // vertex, cell and edge_id return ids that exist in the mesh for any 16-bit `local`, because a changed record may
    // hold any number.
    [[nodiscard]] Index vertex(Index local) const {
        const auto ghosts = static_cast<Index>(ghost_vertex.size());
        return local < ghosts ? ghost_vertex[local] : std::min(own_vertex_begin + local - ghosts, last_vertex);
    }
    [[nodiscard]] Index cell(Index local) const { return cell_begin + std::min(local, cell_count - 1); }
    // Returns the number of vertices per part. The local vertices are divided into at most 64 parts of consecutive
    // vertices, so that a word has one bit for each part.
    [[nodiscard]] Index vertices_per_part() const { return 8 * std::max<Index>(1, (vertex_count + 511) / 512); }
    [[nodiscard]] Index edge_id(Index local) const {
        const auto ghosts = static_cast<Index>(ghost_edge.size());
        return local < ghosts ? ghost_edge[local] : std::min(edge_begin + local - ghosts, last_edge);
    }
    // Return an index in `standard`, or standard.size() if the half-edge or entry is in the PolyhedralSection.
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

// The position of a half-edge in its face. The half-edges of a face have consecutive local ids, in the direction of the
// face or against it.
struct PlaceInFace {
    Index first, place, size; // lowest local id in the face, distance of the half-edge from it, number of half-edges
    bool backwards;

    // Returns the half-edge that is `steps` forward around the face.
    [[nodiscard]] Index turned(Index steps) const {
        return first + (place + (backwards ? size - steps % size : steps)) % size;
    }
};

template <template <class> class Array>
[[nodiscard]] PlaceInFace place_in_face(const StandardSectionOf<Array>& section, Index local_half_edge) {
    const StandardShape& shape = *section.shape;
    const Index of_cell = (local_half_edge - section.half_edge_begin) % shape.half_edges;
    const Index face = shape.face[of_cell], begin = shape.face_begin[face];
    return {local_half_edge - of_cell + begin, of_cell - begin, shape.face_size(face), false};
}

// REQUIRES: the half-edge is not in an inner face of the PolyhedralSection, because ids in such a face are not
// consecutive.
template <template <class> class Array>
[[nodiscard]] PlaceInFace place_in_face(const BlockOf<Array>& block, Index local_half_edge) {
    if (const std::size_t s = block.section_of_half_edge(local_half_edge); s < block.standard.size())
        return place_in_face(block.standard[s], local_half_edge);
    return block.with([&](const auto& polyhedra) -> PlaceInFace {
        const Index corner = polyhedra.corner(local_half_edge - polyhedra.half_edge_begin);
        const auto loop = polyhedra.loop(polyhedra.face(corner));
        return {polyhedra.half_edge_begin + polyhedra.half_edge(loop.begin, 0), corner - loop.begin, loop.size(),
                corner >= polyhedra.far_corner};
    });
}

// Returns the local half-edge that is `steps` forward of a local half-edge around its face. Throws Error if the record
// has changed and the corners of the face do not exist.
template <template <class> class Array>
[[nodiscard]] Index turn(const BlockOf<Array>& block, Index local_half_edge, Index steps) {
    if (const std::size_t s = block.section_of_half_edge(local_half_edge); s < block.standard.size())
        return place_in_face(block.standard[s], local_half_edge).turned(steps);
    return block.with([&](const auto& polyhedra) {
        const Index local = local_half_edge - polyhedra.half_edge_begin;
        const Index corner = polyhedra.corner(local), side = polyhedra.side(local);
        const auto loop = polyhedra.loop(polyhedra.face(corner));
        if (!loop.has(corner) || loop.end > polyhedra.vertex.size())
            refuse_changed("the corners of a face do not exist");
        const Index n = loop.size(), forward = side == 0 ? steps % n : n - steps % n;
        return polyhedra.half_edge_begin + polyhedra.half_edge(loop.begin + (corner - loop.begin + forward) % n, side);
    });
}

} // namespace ciel::detail
