// The asymptotic decider against the twin: random values on every mesh, and all 256 high-low patterns of a hexahedron,
// which include the classic configurations.
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <random>
#include <tuple>

namespace ciel::test {
namespace {

class Decided : public testing::TestWithParam<std::tuple<NamedMesh, Algorithm>> {};

std::size_t polygons_that_differ(const Cut& a, const Cut& b) {
    std::vector<CutPolygon> found;
    std::ranges::set_difference(a.polygons, b.polygons, std::back_inserter(found));
    return found.size();
}

TEST_P(Decided, SurfacesAreTheTwinsAndClosed) {
    const Polyhedra input = std::get<0>(GetParam()).make();
    const KernelMesh mesh(input, {32});
    Query query = mesh.query(std::get<1>(GetParam()));
    query.set_decider(Decider::asymptotic);
    Surface surface;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const std::vector<float> values = random_field(input.vertex_count(), seed);
        const Field field = make_field(mesh.topology, mesh.stored(values));
        query.set_field(field);
        // Some successive iso-values have equal vertex signatures, others different ones.
        for (const double nu : {0.5, 0.51, 0.5100001, 0.3, 0.7, 0.5}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + " at " + std::to_string(nu));
            ASSERT_TRUE(query.extract(nu, false, surface));
            const Cut actual = mesh.cut(surface);
            ASSERT_EQ(difference(cut_every_cell(input, values, nu, Joined::asymptotic), actual), "");
            const Segments boundary = boundary_segments(input, values, nu, Joined::asymptotic);
            ASSERT_EQ(open_segment(polygon_segments(actual.polygons), boundary), "");
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Decided,
                         testing::Combine(testing::ValuesIn(all_meshes()),
                                          testing::Values(Algorithm::signatures, Algorithm::propagation)),
                         [](const auto& test) {
                             return std::get<0>(test.param).name +
                                    (std::get<1>(test.param) == Algorithm::signatures ? "_signatures" : "_propagation");
                         });

TEST(DeciderOnOneHexahedron, EveryConfigurationIsTheTwins) {
    const Polyhedra input = hexahedra({{1, 1, 1}});
    const KernelMesh mesh(input, {32});
    Query query = mesh.query(Algorithm::signatures);
    query.set_decider(Decider::asymptotic);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> size(0.01F, 1);
    std::size_t joined = 0;
    Surface surface;
    for (unsigned high = 0; high < 256; ++high)
        for (int i = 0; i < 20; ++i) {
            std::vector<float> values;
            for (unsigned corner = 0; corner < 8; ++corner)
                values.push_back((high >> corner & 1) != 0 ? size(random) : -size(random));
            const Field field = make_field(mesh.topology, mesh.stored(values));
            query.set_field(field);
            ASSERT_TRUE(query.extract(0, false, surface));
            const Cut actual = mesh.cut(surface);
            ASSERT_EQ(difference(cut_every_cell(input, values, 0, Joined::asymptotic), actual), "") << high;
            joined += polygons_that_differ(actual, cut_every_cell(input, values, 0)) > 0 ? 1 : 0;
        }
    EXPECT_GT(joined, 500U); // otherwise the decider never joined anything
}

// Saddle of known height on a face: below it the two high corners are joined, above it they are separate.
TEST(DeciderOnOneHexahedron, TheSaddleOfAFaceIsTheHeightAtWhichItsCornersPart) {
    const Polyhedra input = hexahedra({{1, 1, 1}});
    const KernelMesh mesh(input, {32});
    std::vector<float> values(8, 0);
    for (std::size_t v = 0; v < 8; ++v) {
        const float x = input.positions[3 * v], y = input.positions[3 * v + 1], z = input.positions[3 * v + 2];
        values[v] = z > 0 ? -1 : (x == y ? 1.0F : 0.0F); // the bilinear saddle of the lower face is at 0.5
    }
    const Field field = make_field(mesh.topology, mesh.stored(values));
    Query query = mesh.query(Algorithm::signatures);
    query.set_field(field);
    query.set_decider(Decider::asymptotic);
    Surface surface;
    ASSERT_TRUE(query.extract(0.49, false, surface));
    EXPECT_EQ(surface.polygon_cell.size(), 1U);
    ASSERT_TRUE(query.extract(0.51, false, surface));
    EXPECT_EQ(surface.polygon_cell.size(), 2U);
    query.set_decider(Decider::isolate_high);
    ASSERT_TRUE(query.extract(0.49, false, surface));
    EXPECT_EQ(surface.polygon_cell.size(), 2U);
}

} // namespace
} // namespace ciel::test
