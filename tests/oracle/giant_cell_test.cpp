// A cell with more half-edges than 16 bits can number, among small cells.
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

namespace ciel::test {
namespace {

class GiantCell : public testing::TestWithParam<Index> {
protected:
    const Polyhedra input = giant_cell(56); // one cell of 75,264 half-edges
    const KernelMesh mesh{input, {GetParam()}};
};

TEST_P(GiantCell, OperatorsHold) {
    const Topology& topology = mesh.topology;
    ASSERT_EQ(topology.counts().half_edges, 24U * 56 * 56 * 2);
    std::vector<HalfEdge> half_edges;
    for (Index c = 0; c < mesh.mesh().cell_count(); ++c) {
        for (HalfEdge h : topology.half_edges(c)) half_edges.push_back(h);
    }
    std::size_t between_cells = 0;
    for (HalfEdge h : half_edges) {
        const HalfEdge mate = topology.mate_face(h), beyond = topology.mate_polyhedron(h);
        ASSERT_EQ(topology.mate_face(mate), h);
        ASSERT_EQ(topology.edge(mate), topology.edge(h));
        HalfEdge around = h;
        for (int i = 0; i < 4; ++i) around = topology.next_around_face(around);
        ASSERT_EQ(around, h);
        if (beyond == no_half_edge) continue;
        ASSERT_EQ(topology.mate_polyhedron(beyond), h);
        ASSERT_EQ(topology.vertex(beyond), topology.vertex(mate));
        ++between_cells;
    }
    EXPECT_EQ(between_cells, 8U * 56 * 56 + 2 * 4U * 2 * 56 * 55);
    // Every half-edge leaves one vertex, so the rings of all vertices visit each half-edge once.
    std::size_t in_rings = 0;
    for (Index v = 0; v < mesh.mesh().vertex_count(); ++v) {
        const HalfEdge start = topology.half_edge_of_vertex(v);
        HalfEdge h = start;
        do {
            ASSERT_EQ(topology.vertex(topology.mate_face(h)), v);
            h = topology.next_around_vertex(h);
            ++in_rings;
        } while (h != start && in_rings <= half_edges.size());
    }
    EXPECT_EQ(in_rings, half_edges.size());
}

TEST_P(GiantCell, IsCutLikeAnyOther) {
    for (Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
        Query query = mesh.query(algorithm);
        for (const std::vector<float>& values : {random_field(input.vertex_count(), 131), bumps_field(input, 132)}) {
            const Field field = make_field(mesh.topology, mesh.stored(values));
            query.set_field(field);
            for (double nu : {0.5, 0.52, 0.3}) {
                Surface surface;
                ASSERT_TRUE(query.extract(nu, false, surface));
                EXPECT_EQ(difference(cut_every_cell(input, values, nu), mesh.cut(surface)), "") << nu;
                EXPECT_EQ(broken_promise(surface, mesh, mesh.stored(values), nu, false), "") << nu;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(BlockSizes, GiantCell, testing::Values(1U, 256U, 100000U));

// The links of a small block have 16 bits.
TEST(GiantCellWithTooManyNeighbors, IsRefused) {
    const Assembled assembled = assemble(view(giant_cell(256))); // 66,049 shared vertices
    EXPECT_THROW((void)Topology(assembled.mesh.view()), Error);
}

} // namespace
} // namespace ciel::test
