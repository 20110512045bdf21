// Vertex normals never point against their polygons, for any field; lighting would be on the wrong side.
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace ciel::test {
namespace {

std::vector<Vec3d> area_around_points(const Surface& surface) {
    std::vector<Vec3d> sum(surface.points.size());
    for (std::size_t p = 0; p + 1 < surface.polygon_offset.size(); ++p) {
        const auto loop = polygon(surface, p);
        const Vec3d area = vector_area(surface.positions, loop);
        for (const Index v : loop)
            for (std::size_t d = 0; d < 3; ++d) sum[v][d] += area[d];
    }
    return sum;
}

class Normals : public testing::TestWithParam<NamedMesh> {};

TEST_P(Normals, NeverPointAgainstTheSurface) {
    const Polyhedra input = GetParam().make();
    const KernelMesh mesh(input);
    std::size_t seen = 0;
    for (const NamedField& made : all_fields()) {
        const std::vector<float> values = made.make(input);
        const Field field = make_field(mesh.topology, mesh.stored(values));
        Query query = mesh.query();
        query.set_field(field);
        Surface surface;
        const auto [low, high] = field.range();
        for (const double share : {0.2, 0.5, 0.8}) {
            ASSERT_TRUE(query.extract(low + share * (double{high} - low), true, surface));
            const std::vector<Vec3d> areas = area_around_points(surface);
            ASSERT_EQ(surface.normals.size(), areas.size());
            for (std::size_t v = 0; v < areas.size(); ++v) {
                const Vec3f& n = surface.normals[v];
                const Vec3d& area = areas[v];
                const double size = std::hypot(area[0], area[1], area[2]);
                EXPECT_GE(n[0] * area[0] + n[1] * area[1] + n[2] * area[2], -1e-5 * size) << made.name << ' ' << share;
                ++seen;
            }
        }
    }
    EXPECT_TRUE(seen > 0 || input.cell_count() == 0);
}

// Normals from polygons are the area-weighted mean around each point, bit-identical for any block size.
TEST_P(Normals, FromPolygonsAreTheirMean) {
    const Polyhedra input = GetParam().make();
    const std::vector<float> values = random_field(input.vertex_count(), 9);
    std::vector<Surface> made;
    for (const Index size : {7U, 64U, 4096U}) {
        const KernelMesh mesh(input, {size});
        const Field field = make_field(mesh.topology, mesh.stored(values));
        Query query = mesh.query();
        query.set_field(field);
        query.set_normals(ciel::Normals::polygons);
        Surface& surface = made.emplace_back();
        ASSERT_TRUE(query.extract(0.5, true, surface));
        EXPECT_EQ(bit_difference(made.front(), surface, Chunks::ignore), "") << size;
        const std::vector<Vec3d> areas = area_around_points(surface);
        ASSERT_EQ(surface.normals.size(), areas.size());
        for (std::size_t v = 0; v < areas.size(); ++v) {
            const double length = std::hypot(areas[v][0], areas[v][1], areas[v][2]);
            if (length < 1e-9) continue; // polygons around this point cancel each other
            for (std::size_t d = 0; d < 3; ++d) ASSERT_NEAR(surface.normals[v][d], areas[v][d] / length, 1e-5);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Normals, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

} // namespace
} // namespace ciel::test
