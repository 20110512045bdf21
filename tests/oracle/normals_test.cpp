// The normals of a surface never point against it, whatever the field: a light would fall on its wrong side.
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

INSTANTIATE_TEST_SUITE_P(All, Normals, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

} // namespace
} // namespace ciel::test
