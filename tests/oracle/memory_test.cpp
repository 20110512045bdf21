// Memory of the six operators, for blocks of the usual size. Detects a block that uses wider ids or the general form
// without need.
#include "oracle/kernel_mesh.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace ciel::test {
namespace {

double bytes_per_half_edge(const Polyhedra& input) {
    const KernelMesh mesh(input, {});
    return static_cast<double>(mesh.topology.memory_bytes()) / static_cast<double>(mesh.topology.counts().half_edges);
}

void expect_within_5_percent(const Polyhedra& input, double bytes) {
    EXPECT_NEAR(bytes_per_half_edge(input), bytes, 0.05 * bytes);
}

TEST(Memory, AStandardCellsHalfEdgeHasTheBytesThatItHad) {
    const Box box{{24, 24, 24}};
    // One block of almost the maximal size: 4092 cells.
    expect_within_5_percent(tetrahedra({{11, 31, 2}}), 3.19);
    expect_within_5_percent(hexahedra(box), 3.23);
    expect_within_5_percent(wedges(box), 3.27);
    expect_within_5_percent(pyramids(box), 3.14);
}

TEST(Memory, ACellIsRecognisedByItsFacesWhateverItsFileCallsIt) {
    const Box box{{32, 32, 32}};
    for (Polyhedra input : {tetrahedra({{11, 31, 2}}), hexahedra(box), wedges(box), pyramids(box)}) {
        const double standard = bytes_per_half_edge(input);
        std::ranges::fill(input.cell_types, polyhedron);
        EXPECT_EQ(bytes_per_half_edge(input), standard);
    }
}

TEST(Memory, APolyhedronsHalfEdgeHasTheBytesThatItHad) {
    expect_within_5_percent(hexagonal_prisms(20, 20, 20), 5.51);
    expect_within_5_percent(voronoi(8000, 1), 5.86);
}

} // namespace
} // namespace ciel::test
