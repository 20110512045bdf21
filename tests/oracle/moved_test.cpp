// The vertices move under a query, as in a crash simulation. The query keeps its topology and what it has computed for
// the field.
#include "ciel/sweep_sinks.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace ciel::test {
namespace {

class Moved : public testing::TestWithParam<NamedMesh> {};

std::vector<float> sheared(std::span<const float> positions, float by) {
    std::vector<float> moved(positions.begin(), positions.end());
    for (std::size_t i = 0; i < moved.size(); i += 3) {
        moved[i] += by * moved[i + 1];
        moved[i + 2] *= 1 + by;
    }
    return moved;
}

// Sorted positions without duplicates. A point on the border of two blocks occurs in both.
std::vector<Vec3f> in_order(std::vector<Vec3f> positions) {
    std::ranges::sort(positions);
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    return positions;
}

constexpr float shears[]{0.0F, 0.3F, -0.2F, 0.0F};

struct Choice {
    Algorithm algorithm;
    Decider decider;
    ciel::Normals normals;
};
constexpr Choice choices[]{{Algorithm::signatures, Decider::isolate_high, ciel::Normals::gradient},
                           {Algorithm::signatures, Decider::asymptotic, ciel::Normals::polygons},
                           {Algorithm::propagation, Decider::isolate_high, ciel::Normals::polygons},
                           {Algorithm::propagation, Decider::asymptotic, ciel::Normals::gradient},
                           {Algorithm::naive, Decider::isolate_high, ciel::Normals::gradient},
                           {Algorithm::naive, Decider::asymptotic, ciel::Normals::polygons}};

TEST_P(Moved, GivesWhatANewQueryGives) {
    const Polyhedra input = GetParam().make();
    const KernelMesh mesh(input, {32});
    const std::vector<float> stored = mesh.stored(random_field(input.vertex_count(), 6));
    for (const auto& [algorithm, decider, normals] : choices) {
        Field field = make_field(mesh.topology, stored);
        Query query(mesh.topology, mesh.mesh(), {algorithm, decider});
        query.set_normals(normals);
        query.set_field(field);
        for (const float by : shears)
            for (const double nu : {0.5, 0.6}) {
                const std::vector<float> positions = sheared(mesh.mesh().positions.floats(), by);
                FaceMeshView moved = mesh.mesh();
                moved.positions = positions;
                query.set_mesh(moved);
                field.vertices_moved();
                Surface surface, expected;
                ASSERT_TRUE(query.extract(nu, true, surface));
                const Field fresh = make_field(mesh.topology, stored);
                Query other(mesh.topology, moved, {Algorithm::signatures, decider});
                other.set_normals(normals);
                other.set_field(fresh);
                ASSERT_TRUE(other.extract(nu, true, expected));
                ASSERT_EQ(bit_difference(expected, surface), "")
                    << by << ' ' << nu << ", algorithm " << static_cast<int>(algorithm);
            }
    }
}

// A sweep of the moved mesh gives the same result with a field that was used before the move as with a new field.
TEST_P(Moved, IsSweptWhereItIsNow) {
    const Polyhedra input = GetParam().make();
    const KernelMesh mesh(input, {32});
    const std::vector<float> stored = mesh.stored(random_field(input.vertex_count(), 6));
    const std::vector<float> property = mesh.stored(random_field(input.vertex_count(), 7));
    const std::vector<double> values{0.6, 0.5};
    Field field = make_field(mesh.topology, stored);
    const auto swept = [&](const FaceMeshView& at, const Field& of, const auto& sink) {
        std::vector<typename std::decay_t<decltype(sink)>::Out> out;
        EXPECT_TRUE(sweep(mesh.topology, at, of, values, sink, out));
        return out;
    };
    for (const float by : shears) {
        const std::vector<float> positions = sheared(mesh.mesh().positions.floats(), by);
        FaceMeshView moved = mesh.mesh();
        moved.positions = positions;
        field.vertices_moved();
        const Field fresh = make_field(mesh.topology, stored);
        EXPECT_EQ(swept(moved, field, SoupSink{}), swept(moved, fresh, SoupSink{})) << by;
        EXPECT_EQ(swept(moved, field, OutlineSink{}), swept(moved, fresh, OutlineSink{})) << by;
        const auto slices = swept(moved, field, SliceSink{property});
        Query query(mesh.topology, moved);
        query.set_field(fresh);
        for (std::size_t i = 0; i < values.size(); ++i) {
            Surface surface;
            ASSERT_TRUE(query.extract(values[i], false, surface));
            EXPECT_EQ(in_order(slices[i].positions), in_order(surface.positions)) << by;
        }
    }
}

// Slicing a moving mesh changes the field too: it is the distance of the moved vertices.
TEST_P(Moved, IsSlicedWhereItIsNow) {
    const Polyhedra input = GetParam().make();
    const KernelMesh mesh(input, {32});
    Query query = mesh.query();
    std::vector<float> distance;
    for (const float by : shears) {
        const std::vector<float> positions = sheared(mesh.mesh().positions.floats(), by);
        FaceMeshView moved = mesh.mesh();
        moved.positions = positions;
        query.set_mesh(moved);
        const Vec3d normal{0.6, -0.48, 0.64};
        const std::vector<float> next = plane_distance(moved, {0.4, 0.5, 0.6}, normal);
        const Field field = make_field(mesh.topology, next);
        query.set_field(field);
        Surface surface;
        ASSERT_TRUE(query.extract(0, true, surface));
        for (const Vec3f& p : surface.positions) {
            double from_plane = 0;
            for (std::size_t d = 0; d < 3; ++d)
                from_plane += normal[d] * (p[d] + moved.origin[d] - std::array{0.4, 0.5, 0.6}[d]);
            ASSERT_NEAR(from_plane, 0, 1e-5) << by;
        }
    }
}

TEST_P(Moved, ThatIsAnotherMeshIsRefused) {
    const Polyhedra input = GetParam().make();
    const KernelMesh mesh(input);
    Query query = mesh.query();
    FaceMeshView shorter = mesh.mesh();
    if (shorter.vertex_count() == 0) return; // the empty mesh has no vertex to remove
    shorter.positions = shorter.positions.subview(0, shorter.positions.size() - 3);
    EXPECT_THROW(query.set_mesh(shorter), Error);
}

INSTANTIATE_TEST_SUITE_P(All, Moved, testing::ValuesIn(all_meshes()), [](const auto& test) { return test.param.name; });

} // namespace
} // namespace ciel::test
