// The gradients at all vertices need the gradients of the cells only near the block in progress.
#include "allocations/counted_new.hpp"
#include "ciel/assemble.hpp"
#include "ciel/field.hpp"
#include "ciel/topology.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"
#include "support/thread_count.hpp"
#include "support/views.hpp"

#include <gtest/gtest.h>

namespace ciel::test {
namespace {

TEST(VertexGradients, HoldFewGradientsOfCells) {
    constexpr int side = 64;
    constexpr std::size_t cells = std::size_t{side} * side * side, bytes_of_a_cell_gradient = 16;
    const Assembled made = assemble(view(hexahedra({{side, side, side}})));
    const FaceMeshView mesh = made.mesh.view();
    const Topology topology(mesh, {64});
    const std::vector<float> values = random_field(mesh.vertex_count(), 2);
    for (const unsigned threads : {1U, 2U}) {
        const ThreadCount count(threads);
        (void)vertex_gradients(topology, mesh, values); // what is allocated once only
        const PeakBytes peak;
        const std::vector<Vec3f> gradients = vertex_gradients(topology, mesh, values);
        const std::size_t result = gradients.size() * sizeof(Vec3f), ranges = topology.block_count() * 100;
        EXPECT_LT(PeakBytes::peak(), result + ranges + cells * bytes_of_a_cell_gradient / 2) << threads;
        EXPECT_GT(PeakBytes::peak(), result);
    }
}

} // namespace
} // namespace ciel::test
