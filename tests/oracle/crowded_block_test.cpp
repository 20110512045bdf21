// A block of polyhedra may have more half-edges than 16 bits name: the two sides of a face share their corners' ids.
#include "oracle/kernel_mesh.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

namespace ciel::test {
namespace {

// Collapsed faces are where a mate has to be written down in full.
TEST(CrowdedBlock, KeepsTheMatesOfCollapsedFaces) {
    Polyhedra input = o_grid(2, 60, 30);
    for (auto& type : input.cell_types) type = 42;
    const KernelMesh mesh(input);
    ASSERT_EQ(mesh.topology.block_count(), 1U);
    ASSERT_GT(mesh.topology.counts().half_edges, 65536U);
    for (Index cell = 0; cell < mesh.mesh().cell_count(); ++cell)
        for (const HalfEdge h : mesh.topology.half_edges(cell)) {
            const HalfEdge mate = mesh.topology.mate_face(h);
            ASSERT_NE(mate, h);
            ASSERT_EQ(mesh.topology.mate_face(mate), h);
            ASSERT_EQ(mesh.topology.edge(mate), mesh.topology.edge(h));
            ASSERT_EQ(mesh.topology.cell(mate), cell);
        }
}

// Where half of the cells are missing, most faces serve one cell, and a block holds fewer cells.
TEST(CrowdedBlock, KeepsItsShortIdsWhereFewFacesAreShared) {
    const KernelMesh mesh(
        keep_cells(hexagonal_prisms(60, 60, 10), [](Id cell) { return (cell * 2654435761U >> 8) % 2 != 0; }));
    const TopologyCounts& counts = mesh.topology.counts();
    ASSERT_GT(mesh.topology.block_count(), 4U);
    ASSERT_GT(counts.boundary_faces, counts.faces / 2);
    EXPECT_LT(mesh.topology.memory_bytes(), 9 * counts.half_edges);
}

} // namespace
} // namespace ciel::test
