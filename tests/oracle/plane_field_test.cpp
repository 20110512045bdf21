// A plane as a field that stores no values: cuts have the same bits as with a stored distance per vertex.
#include "oracle/kernel_mesh.hpp"
#include "support/copied_records.hpp"
#include "support/kept.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

namespace ciel::test {
namespace {

constexpr Vec3d normal{0.6, 0, 0.8}, origin{0.3, 0.1, 0.2};

class PlaneField : public testing::TestWithParam<NamedMesh> {};

TEST_P(PlaneField, CutsLikeTheDistanceOfEachVertex) {
    const KernelMesh mesh(GetParam().make(), {32});
    const FaceMeshView points = mesh.mesh();
    const Field field =
        Field::plane(mesh.topology, points, origin, normal, block_boxes(mesh.topology, points.positions));
    const std::vector<float> distance = plane_distance(points, origin, normal);
    const Field expected(mesh.topology, distance, kept_by_test);
    EXPECT_EQ(field.range(), expected.range());
    for (Index v = 0; v < distance.size(); ++v) ASSERT_EQ(field.value(v), distance[v]);
    for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation, Algorithm::naive}) {
        Query query = mesh.query(algorithm), other = mesh.query(algorithm);
        query.set_field(field);
        other.set_field(expected);
        for (const double nu : {0.0, 0.25, -0.4}) {
            Surface found, wanted;
            query.extract(nu, true, found);
            other.extract(nu, true, wanted);
            EXPECT_EQ(bit_difference(found, wanted), "") << nu;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, PlaneField, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

TEST(PlaneField, TouchesTheBlocksThatThePlaneCrosses) {
    const KernelMesh mesh(tetrahedra({{12, 12, 12}}), {64});
    auto copied = std::make_unique<CopiedRecords>(mesh.topology);
    const CopiedRecords& source = *copied;
    const Topology topology = read_back(std::move(copied));
    const FaceMeshView points = mesh.mesh();
    const BlockBoxes boxes = block_boxes(mesh.topology, points.positions);
    const Field field = Field::plane(topology, points, points.origin, {1, 0, 0}, boxes);
    EXPECT_EQ(source.reads, 0);
    Query query(topology, points);
    query.set_field(field);
    Surface surface;
    query.extract(0.25, false, surface);
    EXPECT_FALSE(surface.polygon_cell.empty());
    EXPECT_LT(source.reads, static_cast<int>(topology.block_count()) / 2);
}

TEST(PlaneField, OfAnotherMeshIsRefused) {
    const KernelMesh mesh(tetrahedra({{2, 2, 2}})), other(tetrahedra({{3, 2, 2}}), {8});
    const BlockBoxes boxes = block_boxes(mesh.topology, mesh.mesh().positions);
    EXPECT_THROW((void)Field::plane(other.topology, mesh.mesh(), origin, normal, boxes), Error);
    EXPECT_THROW((void)Field::plane(other.topology, other.mesh(), origin, normal, boxes), Error);
}

} // namespace
} // namespace ciel::test
