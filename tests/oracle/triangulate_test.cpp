// Triangles of single polygons, convex or not, and what the functions beside extract() refuse.
#include "oracle/kernel_mesh.hpp"
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

// From every start of the loop: the triangles face the polygon's way and cover it once.
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
                    Shape{"a_corner_twice", {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 1, 2},
                    Shape{"no_area", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, 0, 0}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Refusals, ValuesOfAnotherLength) {
    const KernelMesh mesh(hexahedra({{1, 1, 1}}));
    const std::vector<float> short_by_one(7);
    EXPECT_THROW(Field(mesh.topology, short_by_one, nullptr), Error);
    const std::vector<EdgePoint> points{{0, 1, 0.5F}};
    std::vector<float> out(3);
    EXPECT_THROW(interpolate(points, std::vector<float>(16), 2, out), Error);
}

} // namespace
} // namespace ciel::test
