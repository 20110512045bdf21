// Polygon edges against a brute-force set of them, on surfaces through every kind of mesh, and against known counts.
#include "ciel/polygon_edges.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace ciel::test {
namespace {

using Pairs = std::vector<std::pair<Index, Index>>;

Pairs pairs_of(const std::vector<Index>& edges) {
    Pairs pairs;
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) pairs.emplace_back(edges[i], edges[i + 1]);
    return pairs;
}

Surface cut(const KernelMesh& mesh, const std::vector<float>& stored, double nu) {
    const Field field = make_field(mesh.topology, stored);
    Query query = mesh.query();
    query.set_field(field);
    Surface surface;
    EXPECT_TRUE(query.extract(nu, false, surface));
    return surface;
}

class PolygonEdges : public testing::TestWithParam<NamedMesh> {};

TEST_P(PolygonEdges, AreEachSideOfAPolygonOnce) {
    const Polyhedra input = GetParam().make();
    const KernelMesh mesh(input, {32});
    const Surface surface = cut(mesh, mesh.stored(random_field(input.vertex_count(), 5)), 0.4);
    std::set<std::pair<Index, Index>> expected;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        const std::span<const Index> loop = polygon(surface, i);
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const auto [lower, upper] = std::minmax(loop[k], loop[(k + 1) % loop.size()]);
            if (lower != upper) expected.emplace(lower, upper);
        }
    }
    EXPECT_EQ(pairs_of(polygon_edges(surface)), Pairs(expected.begin(), expected.end()));
}

INSTANTIATE_TEST_SUITE_P(meshes, PolygonEdges, testing::ValuesIn(all_meshes()),
                         [](const auto& mesh) { return mesh.param.name; });

// A plane between two layers of n x n cubes cuts n x n squares: n + 1 lines of n edges in each direction, no diagonals.
TEST(PolygonEdgesOfALattice, AreThoseOfItsSquares) {
    constexpr std::size_t n = 7;
    const Polyhedra input = hexahedra({{n, n, n}});
    const KernelMesh mesh(input);
    const Surface surface = cut(mesh, mesh.stored(linear_field(input, {{1, 0, 0}})), 2.5);
    EXPECT_EQ(surface.polygon_cell.size(), n * n);
    EXPECT_EQ(pairs_of(polygon_edges(surface)).size(), 2 * n * (n + 1));
}

TEST(PolygonEdgesOfNothing, AreNone) { EXPECT_TRUE(polygon_edges(Surface{}).empty()); }

} // namespace
} // namespace ciel::test
