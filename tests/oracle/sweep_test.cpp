// Several values in one pass give, value by value, what a query gives.
#include "ciel/sweep.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace ciel::test {
namespace {

class Sweep : public testing::TestWithParam<NamedMesh> {
protected:
    Polyhedra input = GetParam().make();
    KernelMesh mesh{input, {32}};
    std::vector<float> stored = mesh.stored(random_field(input.vertex_count(), 3));
    Field field = make_field(mesh.topology, stored);
    // In no order, twice the same, outside the range.
    std::vector<double> values{0.5, 0.1, 0.9, 0.5, -1, 2, 0.3};

    Surface surface_at(double nu) {
        Query query = mesh.query(Engine::signatures);
        query.set_field(field);
        Surface surface;
        EXPECT_TRUE(query.extract(nu, false, surface));
        return surface;
    }
    static std::span<const Index> polygon(const Surface& surface, std::size_t i) {
        return std::span(surface.polygon_vertex)
            .subspan(surface.polygon_offset[i], surface.polygon_offset[i + 1] - surface.polygon_offset[i]);
    }
    // Calls f(a, b, c) for each polygon's fan.
    template <class F>
    static void for_fans(const Surface& surface, F&& f) {
        for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
            const std::span<const Index> loop = polygon(surface, i);
            for (std::size_t k = 2; k < loop.size(); ++k) f(loop[0], loop[k - 1], loop[k]);
        }
    }
};

TEST_P(Sweep, ASoupIsTheSurfacesPolygonsAsFans) {
    std::vector<SoupSink::Out> out;
    ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, values, SoupSink{}, out));
    ASSERT_EQ(out.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Surface surface = surface_at(values[i]);
        std::vector<Vec3f> expected;
        for_fans(surface, [&](Index a, Index b, Index c) {
            for (const Index p : {a, b, c}) expected.push_back(surface.positions[p]);
        });
        EXPECT_EQ(out[i], expected) << values[i];
    }
}

TEST_P(Sweep, ASliceHasTheSameTrianglesAndThePropertyAtTheirCorners) {
    const std::vector<float> property = mesh.stored(random_field(input.vertex_count(), 4));
    std::vector<SliceSink::Out> out;
    ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, values, SliceSink{property}, out));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Surface surface = surface_at(values[i]);
        std::vector<float> at_points(surface.points.size());
        interpolate(surface.points, property, 1, at_points);
        std::size_t at = 0;
        for_fans(surface, [&](Index a, Index b, Index c) {
            for (const Index p : {a, b, c}) {
                const Index mine = out[i].triangles.at(at++);
                ASSERT_EQ(out[i].positions.at(mine), surface.positions[p]);
                ASSERT_EQ(out[i].property.at(mine), at_points[p]);
            }
        });
        EXPECT_EQ(at, out[i].triangles.size());
    }
}

TEST_P(Sweep, AnOutlineIsThePolygonsEdges) {
    std::vector<OutlineSink::Out> out;
    ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, values, OutlineSink{}, out));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Surface surface = surface_at(values[i]);
        std::vector<Vec3f> expected;
        for (std::size_t k = 0; k < surface.polygon_cell.size(); ++k) {
            Index before = polygon(surface, k).back();
            for (const Index p : polygon(surface, k)) {
                expected.push_back(surface.positions[before]);
                expected.push_back(surface.positions[p]);
                before = p;
            }
        }
        EXPECT_EQ(out[i], expected) << values[i];
    }
}

INSTANTIATE_TEST_SUITE_P(All, Sweep, testing::ValuesIn(all_meshes()), [](const auto& test) { return test.param.name; });

TEST(SweepStopped, SaysSo) {
    const Polyhedra input = hexahedra({{4, 4, 4}});
    const KernelMesh mesh(input, {8});
    const std::vector<float> stored = mesh.stored(random_field(input.vertex_count(), 3));
    const Field field = make_field(mesh.topology, stored);
    std::stop_source stop;
    stop.request_stop();
    std::vector<SoupSink::Out> out;
    EXPECT_FALSE(sweep(mesh.topology, mesh.mesh(), field, std::vector{0.5}, SoupSink{}, out, stop.get_token()));
}

} // namespace
} // namespace ciel::test
