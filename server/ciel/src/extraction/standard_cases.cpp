#include "extraction/standard_cases.hpp"

#include <utility>

namespace ciel::detail {

namespace {

struct Corners {
    const StandardShape& shape;
    // high: one bit for each high corner. joined: one bit for each face whose high corners are joined.
    std::size_t high, joined;

    [[nodiscard]] bool is_high(std::size_t corner) const { return (high >> corner & 1) != 0; }
    [[nodiscard]] bool climbs(std::size_t h) const { return !is_high(shape.origin[h]) && is_high(shape.target(h)); }
    [[nodiscard]] bool descends(std::size_t h) const { return is_high(shape.origin[h]) && !is_high(shape.target(h)); }
};

// Appends the polygon that enters a face at the half-edge `start`. joined_case (standard_cases.hpp) says where the walk
// leaves a face. The walk continues at the mate of the half-edge where it leaves.
void walk(const Corners& corners, std::size_t start, std::array<bool, 24>& walked, StandardCase& out) {
    const std::size_t begin = out.edges;
    std::size_t h = start;
    do {
        walked[h] = true;
        out.edge[out.edges++] = corners.shape.edge[h];
        const bool joined = (corners.joined >> corners.shape.face[h] & 1) != 0;
        do h = joined ? corners.shape.previous[h] : corners.shape.next[h];
        while (!corners.descends(h));
        h = corners.shape.mate[h];
    } while (h != start);
    // Seen from outside the cell, the walk has the high side on its left. A polygon runs the other way.
    for (std::size_t first = begin, end = out.edges; first + 1 < end; ++first)
        std::swap(out.edge[first], out.edge[--end]);
    out.end[out.polygons++] = out.edges;
}

std::uint8_t ambiguous_faces(const Corners& corners) {
    std::array<int, 6> entries{};
    for (std::size_t h = 0; h < corners.shape.half_edges; ++h)
        if (corners.climbs(h)) ++entries[corners.shape.face[h]];
    unsigned found = 0;
    for (std::size_t face = 0; face < corners.shape.faces; ++face)
        if (entries[face] > 1) found |= 1U << face;
    return static_cast<std::uint8_t>(found);
}

std::vector<StandardCase> make_cases(const StandardShape& shape) {
    std::vector<StandardCase> cases(std::size_t{1} << shape.corners);
    for (Index high = 0; high < cases.size(); ++high) cases[high] = joined_case(shape, high, 0);
    return cases;
}

} // namespace

StandardCase joined_case(const StandardShape& shape, Index high, Index joined) {
    StandardCase out;
    const Corners corners{shape, high, joined};
    std::array<bool, 24> walked{};
    for (std::size_t h = 0; h < shape.half_edges; ++h)
        if (!walked[h] && corners.climbs(h)) walk(corners, h, walked, out);
    out.ambiguous = ambiguous_faces(corners);
    return out;
}

template <const StandardShape& shape>
const std::vector<StandardCase>& standard_cases() {
    static const std::vector<StandardCase> cases = make_cases(shape);
    return cases;
}

template const std::vector<StandardCase>& standard_cases<tetrahedron_shape>();
template const std::vector<StandardCase>& standard_cases<hexahedron_shape>();
template const std::vector<StandardCase>& standard_cases<wedge_shape>();
template const std::vector<StandardCase>& standard_cases<pyramid_shape>();

} // namespace ciel::detail
