// What the six operators cost, in blocks of the usual size: a block that falls back to wider ids or to the general form
// says so here, and nowhere else but in time.
#include "oracle/kernel_mesh.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

namespace ciel::test {
namespace {

double bytes_per_half_edge(const Polyhedra& input) {
    const KernelMesh mesh(input, {});
    return static_cast<double>(mesh.topology.memory_bytes()) / static_cast<double>(mesh.topology.counts().half_edges);
}

TEST(Memory, AStandardCellsHalfEdgeIsLessThanFourAndAHalfBytes) {
    const Box box{{24, 24, 24}};
    // One block as full as blocks get: 4092 cells.
    EXPECT_LT(bytes_per_half_edge(tetrahedra({{11, 31, 2}})), 4.5);
    EXPECT_LT(bytes_per_half_edge(hexahedra(box)), 4.5);
    EXPECT_LT(bytes_per_half_edge(wedges(box)), 4.5);
    EXPECT_LT(bytes_per_half_edge(pyramids(box)), 4.5);
}

TEST(Memory, APolyhedronsHalfEdgeIsLessThanSevenBytes) {
    EXPECT_LT(bytes_per_half_edge(hexagonal_prisms(20, 20, 20)), 7);
    EXPECT_LT(bytes_per_half_edge(voronoi(8000, 1)), 7);
}

} // namespace
} // namespace ciel::test
