// Compile-time tables of the half-edges (paper, section 2.2) of the four standard cell types.
#pragma once

#include "ciel/types.hpp"

namespace ciel::detail {

// Corners are in VTK's order. Half-edges are numbered face by face, along loops that are wound outwards.
struct StandardShape {
    static constexpr std::uint8_t end_of_list = 255;

    CellType type{};
    std::uint8_t corners = 0, faces = 0, edges = 0, half_edges = 0;
    std::array<std::uint8_t, 7> face_begin{}; // first half-edge of each face; then the number of half-edges
    // By half-edge: the corner that the half-edge leaves, its face, the next and the previous half-edge of the face,
    // the opposite half-edge of the same edge, and the edge.
    std::array<std::uint8_t, 24> origin{}, face{}, next{}, previous{}, mate{}, edge{};
    std::array<std::array<std::uint8_t, 2>, 12> edge_ends{}; // the two corners of each edge
    // A linked list for each corner, of the half-edges that leave the corner. first_at_corner: by corner, the first
    // half-edge. next_at_corner: by half-edge, the next half-edge, or end_of_list.
    std::array<std::uint8_t, 8> first_at_corner{};
    std::array<std::uint8_t, 24> next_at_corner{};

    [[nodiscard]] constexpr std::uint8_t target(std::size_t h) const { return origin[next[h]]; }
    [[nodiscard]] constexpr std::uint8_t face_size(std::size_t f) const {
        return static_cast<std::uint8_t>(face_begin[f + 1] - face_begin[f]);
    }
};

// The corners of each face. In a triangle, -1 replaces the fourth corner.
using ShapeLoops = std::array<std::array<int, 4>, 6>;

constexpr void put_loops(StandardShape& shape, const ShapeLoops& loops) {
    std::uint8_t h = 0;
    for (std::size_t f = 0; f < shape.faces; ++f) {
        shape.face_begin[f] = h;
        for (const int corner : loops[f]) {
            if (corner < 0) continue;
            shape.origin[h] = static_cast<std::uint8_t>(corner);
            shape.face[h] = static_cast<std::uint8_t>(f);
            shape.previous[h] = static_cast<std::uint8_t>(h - 1);
            shape.next[h] = static_cast<std::uint8_t>(h + 1);
            ++h;
        }
        shape.next[h - 1U] = shape.face_begin[f];
        shape.previous[shape.face_begin[f]] = static_cast<std::uint8_t>(h - 1);
    }
    shape.face_begin[shape.faces] = h;
    shape.half_edges = h;
}

constexpr void pair_half_edges(StandardShape& shape) {
    for (std::uint8_t h = 0; h < shape.half_edges; ++h) {
        std::uint8_t mate = 0;
        while (shape.origin[mate] != shape.target(h) || shape.target(mate) != shape.origin[h]) ++mate;
        shape.mate[h] = mate;
        if (mate < h) {
            shape.edge[h] = shape.edge[mate];
            continue;
        }
        shape.edge_ends[shape.edges] = {shape.origin[h], shape.target(h)};
        shape.edge[h] = shape.edges++;
    }
}

constexpr StandardShape make_shape(CellType type, std::uint8_t corners, std::uint8_t faces, const ShapeLoops& loops) {
    StandardShape shape;
    shape.type = type;
    shape.corners = corners;
    shape.faces = faces;
    put_loops(shape, loops);
    pair_half_edges(shape);
    shape.first_at_corner.fill(StandardShape::end_of_list);
    for (std::uint8_t h = shape.half_edges; h-- > 0;) {
        shape.next_at_corner[h] = shape.first_at_corner[shape.origin[h]];
        shape.first_at_corner[shape.origin[h]] = h;
    }
    return shape;
}

inline constexpr StandardShape tetrahedron_shape =
    make_shape(CellType::tetrahedron, 4, 4, {{{0, 1, 3, -1}, {1, 2, 3, -1}, {2, 0, 3, -1}, {0, 2, 1, -1}}});
inline constexpr StandardShape hexahedron_shape = make_shape(
    CellType::hexahedron, 8, 6, {{{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}});
inline constexpr StandardShape wedge_shape =
    make_shape(CellType::wedge, 6, 5, {{{0, 1, 2, -1}, {3, 5, 4, -1}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}});
inline constexpr StandardShape pyramid_shape =
    make_shape(CellType::pyramid, 5, 5, {{{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}});

// Returns polyhedron if no standard type matches. `largest`: number of corners of the largest face.
constexpr CellType type_of_faces(std::size_t faces, std::size_t half_edges, std::size_t largest) {
    if (largest > 4) return CellType::polyhedron;
    for (const StandardShape* shape : {&tetrahedron_shape, &hexahedron_shape, &wedge_shape, &pyramid_shape})
        if (faces == shape->faces && half_edges == shape->half_edges) return shape->type;
    return CellType::polyhedron;
}

// If `type` is a standard type, calls f.template operator()<shape>() and returns true; else returns false.
template <class F>
bool with_shape(CellType type, F&& f) {
    switch (type) {
    case CellType::tetrahedron:
        f.template operator()<tetrahedron_shape>();
        return true;
    case CellType::hexahedron:
        f.template operator()<hexahedron_shape>();
        return true;
    case CellType::wedge:
        f.template operator()<wedge_shape>();
        return true;
    case CellType::pyramid:
        f.template operator()<pyramid_shape>();
        return true;
    case CellType::polyhedron:
        break;
    }
    return false;
}

} // namespace ciel::detail
