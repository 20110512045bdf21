#include "blocks/recognise.hpp"

#include <algorithm>

namespace ciel::detail {

namespace {

// Returns the face at which find_corners starts: a triangle of a tetrahedron or wedge, else a quadrangle.
constexpr std::size_t base_face(CellType type) {
    switch (type) {
    case CellType::tetrahedron:
        return 3;
    case CellType::hexahedron:
        return 4;
    default:
        return 0;
    }
}

constexpr bool is_in_face(const StandardShape& shape, std::size_t face, std::size_t corner) {
    for (std::size_t h = shape.face_begin[face]; h < shape.face_begin[face + 1]; ++h)
        if (shape.origin[h] == corner) return true;
    return false;
}

// `corner` is not in the base. Returns the first corner of the base that is joined with `corner` by an edge.
constexpr std::size_t below(const StandardShape& shape, std::size_t base, std::size_t corner) {
    for (std::size_t h = 0; h < shape.half_edges; ++h)
        if (shape.target(h) == corner && is_in_face(shape, base, shape.origin[h])) return shape.origin[h];
    return 0;
}

// Returns a vertex outside the base that is joined with `vertex` by an edge, or none.
Index above(const BlockLoops& loops, std::span<const LoopRef> refs, std::span<const Index> base, Index vertex) {
    for (const LoopRef ref : refs) {
        const Index n = loops.size(ref);
        for (Index i = 0; i < n; ++i) {
            if (loops.vertex_at(ref, i) != vertex) continue;
            const Index before = loops.vertex_at(ref, i == 0 ? n - 1 : i - 1);
            const Index after = loops.vertex_at(ref, i + 1 == n ? 0 : i + 1);
            for (const Index v : {before, after})
                if (std::ranges::find(base, v) == base.end()) return v;
        }
    }
    return none;
}

template <const StandardShape& shape>
bool find_corners(const BlockLoops& loops, std::span<const LoopRef> refs, StandardCell& out) {
    constexpr std::size_t base = base_face(shape.type);
    constexpr Index size = shape.face_size(base);
    const auto found = std::ranges::find_if(refs, [&](LoopRef ref) { return loops.size(ref) == size; });
    if (found == refs.end()) return false;
    std::array<Index, size> bottom;
    for (Index i = 0; i < size; ++i) {
        bottom[i] = loops.vertex_at(*found, i);
        out.corner[shape.origin[shape.face_begin[base] + i]] = bottom[i];
    }
    for (std::size_t c = 0; c < shape.corners; ++c) {
        if (is_in_face(shape, base, c)) continue;
        out.corner[c] = above(loops, refs, bottom, out.corner[below(shape, base, c)]);
        if (out.corner[c] == none) return false;
    }
    for (std::size_t c = 1; c < shape.corners; ++c)
        for (std::size_t d = 0; d < c; ++d)
            if (out.corner[c] == out.corner[d]) return false;
    return true;
}

template <const StandardShape& shape>
bool fits(const BlockLoops& loops, LoopRef ref, std::size_t face, Index turn, const StandardCell& cell) {
    const Index n = shape.face_size(face);
    for (Index i = 0; i < n; ++i)
        if (loops.vertex_at(ref, (turn + i) % n) != cell.corner[shape.origin[shape.face_begin[face] + i]]) return false;
    return true;
}

} // namespace

template <const StandardShape& shape>
bool recognise(const BlockLoops& loops, Index local_cell, StandardCell& out) {
    const std::span<const LoopRef> refs = loops.of_cell(local_cell);
    if (refs.size() != shape.faces || !find_corners<shape>(loops, refs, out)) return false;
    for (std::size_t face = 0; face < shape.faces; ++face) {
        bool found = false;
        for (const LoopRef ref : refs) {
            if (loops.size(ref) != shape.face_size(face)) continue;
            for (Index turn = 0; turn < shape.face_size(face) && !found; ++turn)
                if (fits<shape>(loops, ref, face, turn, out)) {
                    out.loop[face] = ref;
                    out.turn[face] = turn;
                    found = true;
                }
            if (found) break;
        }
        if (!found) return false;
    }
    return true;
}

template bool recognise<tetrahedron_shape>(const BlockLoops&, Index, StandardCell&);
template bool recognise<hexahedron_shape>(const BlockLoops&, Index, StandardCell&);
template bool recognise<wedge_shape>(const BlockLoops&, Index, StandardCell&);
template bool recognise<pyramid_shape>(const BlockLoops&, Index, StandardCell&);

} // namespace ciel::detail
