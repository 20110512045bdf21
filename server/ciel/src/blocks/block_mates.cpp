#include "blocks/block_mates.hpp"

namespace ciel::detail {

template <class Local, template <class> class Array>
Index MateArrays<Local, Array>::mate(const PolyhedralSection<Local, Array>& polyhedra, Index h) const {
    const Index bits = mate_bits(h);
    if (bits == escape) {
        if (mate_escapes.empty()) return none;
        std::size_t low = 0, high = mate_escapes.size();
        while (low + 1 < high) {
            const std::size_t middle = (low + high) / 2;
            (mate_escapes[middle].half_edge <= h ? low : high) = middle;
        }
        return mate_escapes[low].mate;
    }
    const Index k = polyhedra.corner(h), own = polyhedra.face(k);
    const std::span<const Local> faces = polyhedra.faces_of(polyhedra.face_cell[own][polyhedra.side(h)]);
    Index left = longest_search; // corners left to search; a mate beyond them is stored as an escape
    for (Index i = bits; i < faces.size() && left > 0; i += escape) {
        const Index other = faces[i] / 2;
        if (other == own) continue;
        const auto loop = polyhedra.loop(other);
        const Index end = std::min(loop.end, loop.begin + left);
        for (Index at = loop.begin; at < end; ++at)
            if (polyhedra.edge[at] == polyhedra.edge[k]) return polyhedra.half_edge(at, faces[i] % 2);
        left -= end - loop.begin;
    }
    return none;
}

template struct MateArrays<std::uint16_t, Owned>;
template struct MateArrays<std::uint32_t, Owned>;
template struct MateArrays<std::uint16_t, Viewed>;
template struct MateArrays<std::uint32_t, Viewed>;

template <>
HalfEdge BlockMates::twin(Index i) const {
    return std::visit(
        [&](const auto& all) {
            if (i >= twin_half_edge.size()) return no_half_edge;
            const Index there = read_once(all.twin_block[i]); // no_block is greater than every index of a neighbor
            return there >= neighbour.size() ? no_half_edge : half_edge_in(neighbour[there], twin_half_edge[i]);
        },
        arrays);
}

} // namespace ciel::detail
