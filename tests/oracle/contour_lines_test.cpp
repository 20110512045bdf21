// Contour lines continue across polygon edges, on cuts through every kind of mesh.
#include "ciel/contour_lines.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <map>

namespace ciel::test {
namespace {

class ContourLines : public testing::TestWithParam<NamedMesh> {};

// Each line end lies on a polygon edge and occurs once for each polygon at that edge. Positions are compared bit by
// bit.
TEST_P(ContourLines, GoOnInTheNextPolygon) {
    const Polyhedra input = GetParam().make();
    const KernelMesh mesh(input, {32});
    const Field field = make_field(mesh.topology, mesh.stored(random_field(input.vertex_count(), 5)));
    Query query = mesh.query();
    query.set_field(field);
    Surface surface;
    ASSERT_TRUE(query.extract(0.5, false, surface));
    const std::vector<float> stored = mesh.stored(random_field(input.vertex_count(), 6));
    std::vector<float> values(surface.points.size());
    interpolate(surface.points, stored, 1, values);
    const double nu = 0.5;
    const std::vector<Vec3f> lines = contour_lines(surface, values, std::vector<double>{nu});

    // Polygon edges that the contour value crosses, with the number of polygons at each.
    std::map<std::pair<Index, Index>, int> sides;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        const std::span<const Index> loop = polygon(surface, i);
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const auto side = std::minmax(loop[k], loop[(k + 1) % loop.size()]);
            if ((values[side.first] >= nu) != (values[side.second] >= nu)) ++sides[side];
        }
    }
    std::size_t ends = 0;
    for (const auto& [side, count] : sides) ends += static_cast<std::size_t>(count);
    EXPECT_EQ(lines.size(), ends) << "one end per polygon and crossed side";
    std::map<Vec3f, int> met, expected;
    for (const Vec3f& end : lines) ++met[end];
    for (const auto& [side, count] : sides) {
        const double from = values[side.first], to = values[side.second];
        const double t = (nu - from) / (to - from);
        const Vec3f &a = surface.positions[side.first], &b = surface.positions[side.second];
        expected[{lerp(a[0], b[0], t), lerp(a[1], b[1], t), lerp(a[2], b[2], t)}] += count;
    }
    EXPECT_EQ(met, expected);
}

INSTANTIATE_TEST_SUITE_P(meshes, ContourLines, testing::ValuesIn(all_meshes()),
                         [](const auto& mesh) { return mesh.param.name; });

TEST(ContourLinesOfAPolygon, OfNoNumberAreNone) {
    Surface square;
    square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    square.polygon_offset = {0, 4};
    square.polygon_vertex = {0, 1, 2, 3};
    square.polygon_cell = {0};
    const std::vector<float> values{0, 1, 1, 0};
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vec3f> expected = contour_lines(square, values, std::vector{0.5});
    EXPECT_EQ(expected.size(), 2U);
    EXPECT_EQ(contour_lines(square, values, std::vector{nan, 0.5}), expected) << "the others are there all the same";
    EXPECT_EQ(contour_lines(square, values, std::vector{0.5, nan}), expected);
    EXPECT_TRUE(contour_lines(square, values, std::vector{nan}).empty());
}

TEST(ContourLinesOfAPolygon, CutOffEachHighRunAndLeaveOutWhatHasNoValue) {
    Surface square;
    square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    square.polygon_vertex = {0, 1, 2, 3};
    square.polygon_offset = {0, 4};
    square.polygon_cell = {0};
    const std::vector<double> at{0.5};
    EXPECT_EQ(contour_lines(square, std::vector<float>{1, 0, 1, 0}, at).size(), 4U) << "two corners, two segments";
    EXPECT_EQ(contour_lines(square, std::vector<float>{1, 1, 1, 0}, at).size(), 2U);
    EXPECT_EQ(contour_lines(square, std::vector<float>{1, 1, 0, 0}, at),
              (std::vector<Vec3f>{{0, 0.5F, 0}, {1, 0.5F, 0}}));
    EXPECT_TRUE(contour_lines(square, std::vector<float>{1, 1, 1, 1}, at).empty());
    EXPECT_TRUE(
        contour_lines(square, std::vector<float>{1, std::numeric_limits<float>::quiet_NaN(), 0, 0}, at).empty());
    EXPECT_TRUE(contour_lines(square, std::vector<float>{1, 1, 0, 0}, std::vector<double>{}).empty());
    EXPECT_THROW((void)contour_lines(square, std::vector<float>{1, 0}, at), Error);
}

} // namespace
} // namespace ciel::test
