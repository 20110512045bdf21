// Triangulation of single polygons, convex or not, and invalid arguments of the functions beside extract().
#include "oracle/kernel_mesh.hpp"
#include "support/kept.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ciel::test {
namespace {

Surface one_polygon(const std::vector<Vec3f>& positions) {
    Surface surface;
    surface.positions = positions;
    surface.points.resize(positions.size());
    surface.polygon_vertex.resize(positions.size());
    std::iota(surface.polygon_vertex.begin(), surface.polygon_vertex.end(), Index{0});
    surface.polygon_offset = {0, static_cast<Index>(positions.size())};
    surface.polygon_cell = {0};
    return surface;
}

struct Shape {
    const char* name;
    std::vector<Vec3f> corners;
    double area;
    std::size_t triangles;
    friend std::ostream& operator<<(std::ostream& out, const Shape& shape) { return out << shape.name; }
};

class Triangulate : public testing::TestWithParam<Shape> {};

// From every first corner, the triangles have the polygon's orientation and cover it once.
TEST_P(Triangulate, CoversThePolygonOnce) {
    Shape shape = GetParam();
    for (std::size_t start = 0; start < shape.corners.size(); ++start) {
        std::rotate(shape.corners.begin(), shape.corners.begin() + 1, shape.corners.end());
        const Surface surface = one_polygon(shape.corners);
        const std::vector<Index> triangles = triangulate(surface);
        EXPECT_EQ(triangles.size(), 3 * shape.triangles);
        double area = 0;
        for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
            const Vec3d piece = vector_area(surface.positions, std::span(triangles).subspan(t, 3));
            EXPECT_GT(piece[2], 0);
            area += std::hypot(piece[0], piece[1], piece[2]);
        }
        EXPECT_NEAR(area, shape.area, 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, Triangulate,
    testing::Values(Shape{"triangle", {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, 1, 1},
                    Shape{"square", {{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}}, 1, 2},
                    Shape{"dart", {{0, 0, 0}, {4, -2, 0}, {1, 0, 0}, {4, 2, 0}}, 2, 2},
                    Shape{"corner_of_a_wall", {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, 3, 4},
                    Shape{"comb",
                          {{0, 0, 0},
                           {7, 0, 0},
                           {7, 3, 0},
                           {6, 3, 0},
                           {6, 1, 0},
                           {5, 1, 0},
                           {5, 3, 0},
                           {4, 3, 0},
                           {4, 1, 0},
                           {3, 1, 0},
                           {3, 3, 0},
                           {2, 3, 0},
                           {2, 1, 0},
                           {1, 1, 0},
                           {1, 3, 0},
                           {0, 3, 0}},
                          15,
                          14},
                    Shape{"spiral",
                          {{0, 0, 0},
                           {6, 0, 0},
                           {6, 6, 0},
                           {1, 6, 0},
                           {1, 2, 0},
                           {4, 2, 0},
                           {4, 4, 0},
                           {3, 4, 0},
                           {3, 3, 0},
                           {2, 3, 0},
                           {2, 5, 0},
                           {5, 5, 0},
                           {5, 1, 0},
                           {0, 1, 0}},
                          21,
                          12},
                    Shape{"a_corner_twice", {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 1, 2},
                    Shape{"no_area", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, 0, 0}),
    [](const auto& test) { return std::string(test.param.name); });

// With an algorithm of quadratic time, a quarter of a million corners would not end.
constexpr int many = 250'000;

std::vector<Vec3f> giant_comb() {
    std::vector<Vec3f> corners{{static_cast<float>(many / 2), 0, 0}};
    for (int i = many / 2; i > 0; --i) {
        corners.push_back({static_cast<float>(i), i % 2 == 0 ? 3.0F : 1.0F, 0});
        corners.push_back({static_cast<float>(i - 1), i % 2 == 0 ? 3.0F : 1.0F, 0});
    }
    corners.push_back({0, 0, 0});
    return corners;
}

std::vector<Vec3f> giant_circle() {
    std::vector<Vec3f> corners;
    for (int i = 0; i < many; ++i) {
        const double angle = 2 * 3.14159265358979323846 * i / many;
        corners.push_back(
            {static_cast<float>(1000 * std::cos(angle)), static_cast<float>(1000 * std::sin(angle)), 7.0F});
    }
    return corners;
}

struct Covered {
    std::size_t triangles;
    double area, turned_over; // summed areas of triangles with the right and with the wrong orientation
};

Covered cover(const std::vector<Vec3f>& corners) {
    const Surface surface = one_polygon(corners);
    const std::vector<Index> triangles = triangulate(surface);
    Covered sum{triangles.size() / 3, 0, 0};
    for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
        const double area = vector_area(surface.positions, std::span(triangles).subspan(t, 3))[2];
        (area > 0 ? sum.area : sum.turned_over) += std::abs(area);
    }
    return sum;
}

TEST(TriangulateGiant, ACombIsCoveredOnce) {
    const Covered comb = cover(giant_comb());
    // The comb's valleys are collinear, so some triangles have no area and are omitted.
    EXPECT_LE(comb.triangles, static_cast<std::size_t>(many));
    EXPECT_EQ(comb.turned_over, 0);
    EXPECT_NEAR(comb.area, many / 2 * 2.0, 1e-3);
}

TEST(TriangulateGiant, ACircleIsCoveredOnceButForRounding) {
    const Covered circle = cover(giant_circle());
    EXPECT_LE(circle.triangles, static_cast<std::size_t>(many - 2));
    EXPECT_NEAR(circle.area - circle.turned_over, 3.14159265358979 * 1e6, 10);
    EXPECT_LT(circle.turned_over, 1);
}

// A polygon that crosses itself many times has no correct triangulation, but the function must return.
TEST(TriangulateGiant, AScribbleEnds) {
    std::vector<Vec3f> corners;
    std::uint64_t state = 7;
    const auto next = [&state] {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<float>(state >> 40) / static_cast<float>(1 << 24);
    };
    for (int i = 0; i < many; ++i) corners.push_back({next(), next(), 0});
    EXPECT_LE(cover(corners).triangles, static_cast<std::size_t>(many - 2));
}

TEST(Refusals, ValuesOfAnotherLength) {
    const KernelMesh mesh(hexahedra({{1, 1, 1}}));
    const std::vector<float> short_by_one(7);
    EXPECT_THROW(Field(mesh.topology, short_by_one, kept_by_test), Error);
    const std::vector<EdgePoint> points{{0, 1, 0.5F}};
    std::vector<float> out(3);
    EXPECT_THROW(interpolate(points, std::vector<float>(16), 2, out), Error);
}

} // namespace
} // namespace ciel::test
