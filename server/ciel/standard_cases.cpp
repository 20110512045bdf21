#include "ciel/standard_cases.hpp"

#include <algorithm>

namespace ciel {

namespace {

struct Corners {
    const StandardShape& shape;
    std::size_t high;

    [[nodiscard]] bool is_high(std::size_t corner) const { return (high >> corner & 1) != 0; }
    [[nodiscard]] bool climbs(std::size_t h) const { return !is_high(shape.origin[h]) && is_high(shape.target(h)); }
    [[nodiscard]] bool descends(std::size_t h) const { return is_high(shape.origin[h]) && !is_high(shape.target(h)); }
};

// A face is entered where its loop climbs and left at the next active edge, where it descends; the mate of that
// half-edge climbs, in the face on the other side of the edge.
void walk(const Corners& corners, std::size_t start, std::vector<std::uint8_t>& walked, StandardCase& out) {
    const std::size_t begin = out.edges;
    std::size_t h = start;
    do {
        walked[h] = 1;
        out.edge[out.edges++] = corners.shape.edge[h];
        do h = corners.shape.next[h];
        while (!corners.descends(h));
        h = corners.shape.mate[h];
    } while (h != start);
    std::reverse(out.edge.begin() + begin, out.edge.begin() + out.edges); // the walk has the high side on its left
    out.end[out.polygons++] = out.edges;
}

bool has_ambiguous_face(const Corners& corners) {
    std::array<int, 6> entries{};
    for (std::size_t h = 0; h < corners.shape.half_edges; ++h)
        if (corners.climbs(h) && ++entries[corners.shape.face[h]] > 1) return true;
    return false;
}

std::vector<StandardCase> make_cases(const StandardShape& shape) {
    std::vector<StandardCase> cases(std::size_t{1} << shape.corners);
    for (std::size_t high = 0; high < cases.size(); ++high) {
        const Corners corners{shape, high};
        std::vector<std::uint8_t> walked(shape.half_edges, 0);
        for (std::size_t h = 0; h < shape.half_edges; ++h)
            if (walked[h] == 0 && corners.climbs(h)) walk(corners, h, walked, cases[high]);
        cases[high].ambiguous = has_ambiguous_face(corners);
    }
    return cases;
}

} // namespace

template <const StandardShape& shape>
const std::vector<StandardCase>& standard_cases() {
    static const std::vector<StandardCase> cases = make_cases(shape);
    return cases;
}

template const std::vector<StandardCase>& standard_cases<tetrahedron_shape>();
template const std::vector<StandardCase>& standard_cases<hexahedron_shape>();
template const std::vector<StandardCase>& standard_cases<wedge_shape>();
template const std::vector<StandardCase>& standard_cases<pyramid_shape>();

} // namespace ciel
