// The vertices move under a query, as in a crash: it goes on with the topology and what it knows of the field.
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

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

TEST_P(Moved, GivesWhatANewQueryGives) {
    const Polyhedra input = GetParam().make();
    const KernelMesh mesh(input, {32});
    const std::vector<float> stored = mesh.stored(random_field(input.vertex_count(), 6));
    Field field = make_field(mesh.topology, stored);
    Query query = mesh.query();
    query.set_field(field);
    for (const float by : {0.0F, 0.3F, -0.2F, 0.0F})
        for (const double nu : {0.5, 0.6}) {
            const std::vector<float> positions = sheared(mesh.mesh().positions, by);
            FaceMeshView moved = mesh.mesh();
            moved.positions = positions;
            query.set_mesh(moved);
            field.vertices_moved();
            Surface surface, expected;
            ASSERT_TRUE(query.extract(nu, true, surface));
            const Field fresh = make_field(mesh.topology, stored);
            Query other(mesh.topology, moved);
            other.set_field(fresh);
            ASSERT_TRUE(other.extract(nu, true, expected));
            EXPECT_EQ(bit_difference(expected, surface), "") << by << ' ' << nu;
        }
}

TEST_P(Moved, ThatIsAnotherMeshIsRefused) {
    const Polyhedra input = GetParam().make();
    const KernelMesh mesh(input);
    Query query = mesh.query();
    FaceMeshView shorter = mesh.mesh();
    if (shorter.vertex_count() == 0) return; // nothing to take away
    shorter.positions = shorter.positions.first(shorter.positions.size() - 3);
    EXPECT_THROW(query.set_mesh(shorter), Error);
}

INSTANTIATE_TEST_SUITE_P(All, Moved, testing::ValuesIn(all_meshes()), [](const auto& test) { return test.param.name; });

} // namespace
} // namespace ciel::test
