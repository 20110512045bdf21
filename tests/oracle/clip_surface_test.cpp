// A clipped boundary surface and its caps together enclose the kept part of the box.
#include "ciel/clip_surface.hpp"
#include "ciel/threshold_surface.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

namespace ciel::test {
namespace {

double enclosed(const Surface& surface) {
    double six = 0;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        const std::span<const Index> loop = polygon(surface, i);
        for (std::size_t k = 2; k < loop.size(); ++k) {
            const Vec3f &a = surface.positions[loop[0]], &b = surface.positions[loop[k - 1]],
                        &c = surface.positions[loop[k]];
            six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
    }
    return six / 6;
}

constexpr double slack = 1e-5;

class ClipSurface : public testing::Test {
protected:
    Polyhedra input = zoo({{4, 4, 4}, 0, 7, 1});
    KernelMesh mesh{input};
    Surface boundary = threshold_surface(mesh.mesh(), std::vector<std::uint8_t>(mesh.mesh().cell_count(), 1));

    Surface cap(const HalfSpace& plane) {
        const Vec3d away{-plane.normal[0], -plane.normal[1], -plane.normal[2]};
        const Field field = make_field(mesh.topology, plane_distance(mesh.mesh(), mesh.mesh().origin, away));
        Query query = mesh.query();
        query.set_field(field);
        Surface out;
        EXPECT_TRUE(query.extract(plane.offset, false, out));
        return out;
    }
};

TEST_F(ClipSurface, LeavesWithItsCapsTheVolumeThatIsKept) {
    const HalfSpace right{{-1, 0, 0}, 2.3}, front{{0, 1, 0}, -1.2}, on_a_layer{{0, 0, -1}, 3},
        oblique{{-std::sqrt(0.5), -std::sqrt(0.5), 0}, std::sqrt(0.5) * 4};
    const struct {
        std::vector<HalfSpace> planes;
        double volume;
    } rows[] = {{{}, 64},
                {{right}, 2.3 * 16},
                {{right, front}, 2.3 * 2.8 * 4},
                {{front, right}, 2.3 * 2.8 * 4},
                {{right, front, on_a_layer}, 2.3 * 2.8 * 3},
                {{oblique}, 32},
                {{{{-1, 0, 0}, -1}}, 0}};
    for (const auto& row : rows) {
        double sum = enclosed(clip_surface(boundary, {}, row.planes, slack).surface);
        for (const HalfSpace& plane : row.planes)
            sum += enclosed(clip_surface(cap(plane), {}, row.planes, slack).surface);
        EXPECT_NEAR(sum, row.volume, 1e-3);
    }
}

TEST_F(ClipSurface, ACapIsNotCutByItsOwnPlane) {
    const HalfSpace oblique{{0.6, 0.8 * std::sqrt(0.5), 0.8 * std::sqrt(0.5)}, -3.1};
    const Surface whole = cap(oblique);
    ASSERT_FALSE(whole.positions.empty());
    const ClippedSurface cut = clip_surface(whole, {}, std::vector{oblique}, slack);
    EXPECT_EQ(cut.surface.positions, whole.positions);
    EXPECT_EQ(cut.surface.polygon_vertex, whole.polygon_vertex);
}

TEST_F(ClipSurface, SidesStayShared) {
    const std::vector<HalfSpace> planes{{{-0.48, -0.6, -0.64}, 3.3}};
    const Surface cut = clip_surface(boundary, {}, planes, slack).surface;
    std::map<std::pair<Index, Index>, int> sides;
    for (std::size_t i = 0; i < cut.polygon_cell.size(); ++i) {
        const std::span<const Index> loop = polygon(cut, i);
        for (std::size_t k = 0; k < loop.size(); ++k) ++sides[{loop[k], loop[(k + 1) % loop.size()]}];
    }
    const auto distance = [&](Index v) {
        const Vec3f& p = cut.positions[v];
        return -0.48 * p[0] - 0.6 * p[1] - 0.64 * p[2] + 3.3;
    };
    for (const auto& [side, count] : sides) {
        EXPECT_EQ(count, 1);
        if (sides.contains({side.second, side.first})) continue;
        EXPECT_NEAR(std::abs(distance(side.first)) + std::abs(distance(side.second)), 0, 1e-5)
            << "open only along the plane";
    }
}

TEST_F(ClipSurface, ValuesAndNormalsAreInterpolated) {
    Surface surface = boundary;
    std::vector<float> values;
    for (const Vec3f& p : surface.positions) {
        values.push_back(p[0] + 2 * p[1] - p[2]);
        surface.normals.push_back({0, 0, 1});
    }
    const ClippedSurface cut = clip_surface(surface, values, std::vector<HalfSpace>{{{-0.6, -0.8, 0}, 2.6}}, slack);
    ASSERT_EQ(cut.values.size(), cut.surface.positions.size());
    ASSERT_EQ(cut.surface.normals.size(), cut.surface.positions.size());
    EXPECT_GT(cut.surface.positions.size(), cut.surface.points.size()) << "the new ones come last";
    for (std::size_t i = 0; i < cut.values.size(); ++i) {
        const Vec3f& p = cut.surface.positions[i];
        EXPECT_NEAR(cut.values[i], p[0] + 2 * p[1] - p[2], 1e-5);
        EXPECT_EQ(cut.surface.normals[i], (Vec3f{0, 0, 1}));
    }
    EXPECT_THROW((void)clip_surface(surface, std::span(values).first(1), {}, slack), Error);
}

// The rounding error at a far vertex is larger than the distance of a near one from the plane.
TEST(ClipSurfaceFar, ANewVertexLiesInThePlane) {
    Surface surface;
    surface.positions = {{-1e30F, 0, 0}, {0, 0, 0}, {0, 1, 0}};
    surface.points = {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}};
    surface.polygon_offset = {0, 3};
    surface.polygon_vertex = {0, 1, 2};
    surface.polygon_cell = {0};
    const std::vector<float> values{-1e30F, 0, 0};
    for (const double side : {-1.0, 1.0}) {
        const ClippedSurface cut = clip_surface(surface, values, std::vector{HalfSpace{{side, 0, 0}, side}}, 0);
        const std::size_t kept = side < 0 ? 1 : 2;
        ASSERT_EQ(cut.surface.positions.size(), kept + 2);
        for (std::size_t p = kept; p < kept + 2; ++p) {
            EXPECT_EQ(cut.surface.positions[p][0], -1);
            EXPECT_EQ(cut.values[p], -1);
        }
    }
}

} // namespace
} // namespace ciel::test
