// A block of polyhedra may have more than 65536 half-edges and still use 16-bit ids, because both sides of a face share
// corner ids.
#include "oracle/kernel_mesh.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace ciel::test {
namespace {

// Splits the faces across z into triangles, so that no cell counts as a hexahedron.
Polyhedra with_split_sides(const Polyhedra& mesh) {
    Polyhedra split;
    split.positions = mesh.positions;
    for (Id cell = 0; cell < mesh.cell_count(); ++cell) {
        std::vector<Loop> loops;
        for (const Loop& loop : mesh.loops(cell)) {
            const double z = mesh.position(loop[0])[2];
            if (std::ranges::any_of(loop, [&](Id vertex) { return mesh.position(vertex)[2] != z; })) {
                loops.push_back(loop);
                continue;
            }
            const Loop from_least = canonical(loop); // both cells at the face get the same diagonal
            loops.push_back({from_least[0], from_least[1], from_least[2]});
            loops.push_back({from_least[0], from_least[2], from_least[3]});
        }
        split.add_cell(polyhedron, loops);
    }
    return split;
}

// For collapsed faces, mates are stored explicitly.
TEST(CrowdedBlock, KeepsTheMatesOfCollapsedFaces) {
    const KernelMesh mesh(with_split_sides(o_grid(2, 60, 26)));
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

// Half of the cells are missing, so most faces have one cell and blocks hold fewer cells.
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
