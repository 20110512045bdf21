// Lobes of a cell: closed parts of its boundary that can be turned separately.
#include "mesh/cell_winding.hpp"
#include "unit/ciel/meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace ciel::test {
namespace {

using Filled = std::function<bool(int i, int j, int k)>;

// Joins the filled cubes of an n x n x n lattice into one cell, without the faces between two filled cubes.
Polyhedra cubes_as_one_cell(int n, const Filled& filled) {
    Polyhedra out;
    const auto at = [n](int i, int j, int k) { return static_cast<Index>((k * (n + 1) + j) * (n + 1) + i); };
    for (int k = 0; k <= n; ++k)
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) out.vertex(i, j, k);
    const auto is_filled = [&](const std::array<int, 3>& c) {
        return std::ranges::all_of(c, [n](int x) { return x >= 0 && x < n; }) && filled(c[0], c[1], c[2]);
    };
    std::vector<std::vector<Index>> faces;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                for (std::size_t axis = 0; axis < 3 && is_filled({i, j, k}); ++axis)
                    for (const int side : {0, 1}) {
                        std::array<int, 3> beyond{i, j, k}, a{i, j, k}, b, c, d;
                        beyond[axis] += 2 * side - 1;
                        if (is_filled(beyond)) continue;
                        a[axis] += side;
                        b = c = d = a;
                        ++b[(axis + 1) % 3], ++c[(axis + 1) % 3], ++c[(axis + 2) % 3], ++d[(axis + 2) % 3];
                        faces.push_back(
                            {at(a[0], a[1], a[2]), at(b[0], b[1], b[2]), at(c[0], c[1], c[2]), at(d[0], d[1], d[2])});
                        if (side == 0) std::ranges::reverse(faces.back());
                    }
    out.polyhedron(faces);
    return out;
}

std::vector<Index> lobes_of(const Polyhedra& cell) {
    const PolyhedraView view = cell.view();
    const detail::InputFaces faces(view);
    return detail::CellWinding(faces).lobes(0);
}

// Expects each edge of each lobe to occur an even number of times. The cell's faces are quadrilaterals.
void expect_closed_each(const Polyhedra& cell, const std::vector<Index>& lobes) {
    std::vector<std::array<Index, 3>> uses; // lobe and the two vertices of an edge
    for (std::size_t f = 0; f < lobes.size(); ++f)
        for (std::size_t i = 0; i < 4; ++i) {
            const Index a = cell.face_vertex[4 * f + i], b = cell.face_vertex[4 * f + (i + 1) % 4];
            uses.push_back({lobes[f], std::min(a, b), std::max(a, b)});
        }
    std::ranges::sort(uses);
    ASSERT_EQ(uses.size() % 2, 0U);
    for (std::size_t i = 0; i < uses.size(); i += 2) ASSERT_EQ(uses[i], uses[i + 1]) << "lobe " << uses[i][0];
}

TEST(Lobes, AreClosedEach) {
    std::mt19937 random(5);
    for (int run = 0; run < 40; ++run) {
        std::vector<bool> filled(125);
        for (std::size_t i = 0; i < filled.size(); ++i) filled[i] = random() % 3 == 0;
        const Polyhedra cell = cubes_as_one_cell(5, [&](int i, int j, int k) { return filled[i + 5 * j + 25 * k]; });
        expect_closed_each(cell, lobes_of(cell));
    }
}

// Each of the 600,000 faces starts as a lobe and is joined with others at edges of four faces. An algorithm of
// quadratic time would not end here.
TEST(Lobes, OfAGiantCellThatTouchesItselfEverywhere) {
    const Polyhedra cell = cubes_as_one_cell(60, [](int i, int j, int k) { return (i + j + k) % 2 == 0; });
    const std::vector<Index> lobes = lobes_of(cell);
    ASSERT_GT(lobes.size(), 600'000U);
    expect_closed_each(cell, lobes);
}

// 400,000 faces meet at one edge.
TEST(Lobes, OfAGiantCellAroundOneEdge) {
    constexpr Index pages = 200'000;
    Polyhedra cell;
    const Index bottom = cell.vertex(0, 0, 0), top = cell.vertex(0, 0, 1);
    std::vector<std::vector<Index>> faces;
    for (Index page = 0; page < pages; ++page) {
        const double angle = 6.28 * page / pages;
        const Index a = cell.vertex(std::cos(angle), std::sin(angle), 0);
        const Index b = cell.vertex(std::cos(angle + 3 / double{pages}), std::sin(angle + 3 / double{pages}), 0.5);
        for (const std::vector<Index>& face :
             {std::vector{bottom, b, a}, std::vector{bottom, a, top}, std::vector{a, b, top}, {bottom, top, b}})
            faces.push_back(face);
    }
    cell.polyhedron(faces);
    const std::vector<Index> lobes = lobes_of(cell);
    ASSERT_EQ(lobes.size(), 4 * std::size_t{pages});
    for (std::size_t f = 0; f < lobes.size(); ++f) ASSERT_EQ(lobes[f], f / 4);
}

} // namespace
} // namespace ciel::test
