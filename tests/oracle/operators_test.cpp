// Identities of the six operators on every half-edge of every mesh, and the topology's counts against counting.
#include "oracle/kernel_mesh.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace ciel::test {
namespace {

using Pair = std::pair<Index, Index>;

Pair unordered(Index a, Index b) { return std::minmax(a, b); }

// A face loop as the topology stores it, without consecutive duplicates: a half-edge joins two different vertices.
Loop half_edge_loop(const Ids& loop) {
    Loop result = without_repeats({loop.begin(), loop.end()});
    if (result.size() == 1) result.clear();
    return result;
}

class Operators : public testing::TestWithParam<std::tuple<NamedMesh, Index>> {
protected:
    KernelMesh mesh{std::get<0>(GetParam()).make(), {std::get<1>(GetParam())}};
    const Topology& topology = mesh.topology;
    std::vector<HalfEdge> half_edges;
    std::map<HalfEdge, Index> origin;

    void SetUp() override {
        for (Index c = 0; c < mesh.mesh().cell_count(); ++c) {
            for (HalfEdge h : topology.half_edges(c)) half_edges.push_back(h);
        }
        for (HalfEdge h : half_edges) origin[topology.next_around_face(h)] = topology.vertex(h);
    }

    Pair ends(HalfEdge h) const { return unordered(origin.at(h), topology.vertex(h)); }
};

TEST_P(Operators, HalfEdgesAreDistinctAndKnowTheirCell) {
    EXPECT_EQ(origin.size(), half_edges.size()); // next_around_face is a permutation
    EXPECT_EQ(topology.counts().half_edges, half_edges.size());
    for (Index c = 0; c < mesh.mesh().cell_count(); ++c) {
        const std::vector<HalfEdge> own = topology.half_edges(c);
        for (HalfEdge h : own) EXPECT_EQ(topology.cell(h), c);
        EXPECT_NE(std::find(own.begin(), own.end(), topology.half_edge_begin(c)), own.end());
    }
}

TEST_P(Operators, NextAroundFaceRunsThroughTheLoopsOfTheMesh) {
    const FaceMeshView faces = mesh.mesh();
    std::map<Index, std::multiset<Loop>> expected, found;
    for (Index f = 0; f < faces.face_count(); ++f) {
        Loop loop = half_edge_loop(faces.loop(f));
        if (loop.empty()) continue;
        expected[faces.owner[f]].insert(canonical(loop));
        std::reverse(loop.begin(), loop.end());
        if (faces.neighbour[f] != none) expected[faces.neighbour[f]].insert(canonical(loop));
    }
    std::set<HalfEdge> seen;
    for (HalfEdge start : half_edges) {
        if (seen.contains(start)) continue;
        Loop loop;
        for (HalfEdge h = start; seen.insert(h).second; h = topology.next_around_face(h)) {
            ASSERT_EQ(topology.cell(h), topology.cell(start));
            loop.push_back(topology.vertex(h));
        }
        found[topology.cell(start)].insert(canonical(loop));
    }
    EXPECT_EQ(found, expected);
}

TEST_P(Operators, MateFaceIsItsOwnInverseInsideTheCell) {
    for (HalfEdge h : half_edges) {
        const HalfEdge mate = topology.mate_face(h);
        ASSERT_NE(mate, h);
        ASSERT_EQ(topology.mate_face(mate), h);
        ASSERT_EQ(topology.cell(mate), topology.cell(h));
        ASSERT_EQ(topology.vertex(mate), origin.at(h));
        ASSERT_EQ(origin.at(mate), topology.vertex(h));
        ASSERT_EQ(topology.edge(mate), topology.edge(h));
    }
}

TEST_P(Operators, MatePolyhedronIsItsOwnInverseOrNoneOnTheBoundary) {
    std::uint64_t without = 0;
    for (HalfEdge h : half_edges) {
        const HalfEdge mate = topology.mate_polyhedron(h);
        // Faces match as a whole: the mate of the next half-edge is the previous one of the mate.
        const HalfEdge beside = topology.mate_polyhedron(topology.next_around_face(h));
        ASSERT_EQ(mate == no_half_edge, beside == no_half_edge);
        if (mate == no_half_edge) {
            ++without;
            continue;
        }
        ASSERT_EQ(topology.mate_polyhedron(mate), h);
        ASSERT_NE(topology.cell(mate), topology.cell(h));
        ASSERT_EQ(topology.vertex(mate), origin.at(h));
        ASSERT_EQ(origin.at(mate), topology.vertex(h));
        ASSERT_EQ(topology.edge(mate), topology.edge(h));
        ASSERT_EQ(topology.next_around_face(beside), mate);
    }
    const FaceMeshView faces = mesh.mesh();
    std::uint64_t on_boundary = 0;
    for (Index f = 0; f < faces.face_count(); ++f) {
        if (faces.neighbour[f] == none) on_boundary += half_edge_loop(faces.loop(f)).size();
    }
    EXPECT_EQ(without, on_boundary);
}

TEST_P(Operators, MatePolyhedronLeadsToTheCellThatTheMeshNames) {
    const FaceMeshView faces = mesh.mesh();
    std::multiset<Pair> expected, found; // pairs of cells, one for each half-edge of the owner
    for (Index f = 0; f < faces.face_count(); ++f) {
        if (faces.neighbour[f] == none) continue;
        for (std::size_t i = half_edge_loop(faces.loop(f)).size(); i > 0; --i) {
            expected.emplace(faces.owner[f], faces.neighbour[f]);
        }
    }
    for (HalfEdge h : half_edges) {
        const HalfEdge mate = topology.mate_polyhedron(h);
        if (mate == no_half_edge || topology.cell(mate) < topology.cell(h)) continue;
        found.emplace(topology.cell(h), topology.cell(mate));
    }
    EXPECT_EQ(found, expected);
}

TEST_P(Operators, EdgeIdsAreDenseAndOnePerPairOfVertices) {
    std::map<Index, Pair> pair_of;
    std::map<Pair, Index> id_of;
    for (HalfEdge h : half_edges) {
        const Index id = topology.edge(h);
        ASSERT_LT(id, topology.counts().edges);
        ASSERT_EQ(pair_of.emplace(id, ends(h)).first->second, ends(h));
        ASSERT_EQ(id_of.emplace(ends(h), id).first->second, id);
    }
    EXPECT_EQ(pair_of.size(), topology.counts().edges);
}

TEST_P(Operators, NextAroundVertexVisitsAllThatLeaveAVertexOnce) {
    std::map<Index, std::set<HalfEdge>> leaving;
    for (HalfEdge h : half_edges) leaving[origin.at(h)].insert(h);
    for (Index v = 0; v < mesh.mesh().vertex_count(); ++v) {
        const HalfEdge start = topology.half_edge_of_vertex(v);
        std::set<HalfEdge> ring;
        HalfEdge h = start;
        do {
            ASSERT_TRUE(ring.insert(h).second) << "the ring of " << v << " does not close at its start";
            h = topology.next_around_vertex(h);
        } while (h != start);
        ASSERT_EQ(ring, leaving[v]) << "vertex " << v;
    }
}

TEST_P(Operators, CountsAreWhatIsThere) {
    const FaceMeshView faces = mesh.mesh();
    const TopologyCounts& counts = topology.counts();
    std::set<Index> vertices;
    std::set<Pair> edges;
    std::uint64_t boundary = 0;
    std::vector<Index> root(faces.cell_count());
    std::iota(root.begin(), root.end(), Index{0});
    const auto find = [&](Index c) {
        while (root[c] != c) c = root[c] = root[root[c]];
        return c;
    };
    for (Index f = 0; f < faces.face_count(); ++f) {
        const Loop loop = half_edge_loop(faces.loop(f));
        vertices.insert(loop.begin(), loop.end());
        for (std::size_t i = 0; i < loop.size(); ++i) edges.insert(unordered(loop[i], loop[(i + 1) % loop.size()]));
        if (faces.neighbour[f] == none)
            ++boundary;
        else
            root[find(faces.owner[f])] = find(faces.neighbour[f]);
    }
    std::uint64_t components = 0;
    for (Index c = 0; c < root.size(); ++c) components += find(c) == c ? 1 : 0;
    EXPECT_EQ(counts.vertices, vertices.size());
    EXPECT_EQ(counts.edges, edges.size());
    EXPECT_EQ(counts.faces, faces.face_count());
    EXPECT_EQ(counts.boundary_faces, boundary);
    EXPECT_EQ(counts.cells, faces.cell_count());
    EXPECT_EQ(counts.components, components);
    const Index per_block = std::get<1>(GetParam());
    EXPECT_EQ(topology.block_count(), (faces.cell_count() + per_block - 1) / per_block);
    // Lower bound for tetrahedra, the leanest cells: 16 bits for each corner, each entry of a vertex's list, each edge
    // and each face.
    EXPECT_GE(topology.memory_bytes(), 2 * (4 + 4 + 6 + 4) * half_edges.size() / 12);
}

INSTANTIATE_TEST_SUITE_P(All, Operators,
                         testing::Combine(testing::ValuesIn(all_meshes()), testing::Values(1U, 7U, 256U)),
                         [](const auto& test) {
                             return std::get<0>(test.param).name + "_" + std::to_string(std::get<1>(test.param));
                         });

// Closed forms, computed by hand.
TEST(OperatorCounts, AHexahedralLattice) {
    const KernelMesh mesh(hexahedra({{3, 4, 5}}));
    const TopologyCounts& counts = mesh.topology.counts();
    EXPECT_EQ(counts.vertices, 4U * 5 * 6);
    EXPECT_EQ(counts.edges, 3U * 5 * 6 + 4U * 4 * 6 + 4U * 5 * 5);
    EXPECT_EQ(counts.faces, 4U * 4 * 5 + 3U * 5 * 5 + 3U * 4 * 6);
    EXPECT_EQ(counts.half_edges, 24U * 60);
    EXPECT_EQ(counts.boundary_faces, 2U * (12 + 15 + 20));
    EXPECT_EQ(counts.cells, 60U);
    EXPECT_EQ(counts.components, 1U);
}

TEST(OperatorCounts, Components) {
    const Polyhedra cube = hexahedra({{1, 1, 1}});
    EXPECT_EQ(KernelMesh(joined(joined(cube, cube, {2, 0, 0}), cube, {4, 0, 0})).topology.counts().components, 3U);
}

TEST(OperatorCounts, AVertexThatTwoCellsShareAloneHasOneRing) {
    const Polyhedra cubes = keep_cells(hexahedra({{2, 2, 2}}), [](Id c) { return c == 0 || c == 7; });
    const KernelMesh mesh(cubes);
    const Topology& topology = mesh.topology;
    EXPECT_EQ(topology.counts().vertices, 15U);
    EXPECT_EQ(topology.counts().edges, 24U);
    const auto& ids = mesh.assembled.original_vertex;
    const auto shared = std::find(ids.begin(), ids.end(), 13U); // the middle vertex of 3 x 3 x 3
    ASSERT_NE(shared, ids.end());
    const HalfEdge start = topology.half_edge_of_vertex(static_cast<Index>(shared - ids.begin()));
    std::multiset<Index> ring;
    HalfEdge h = start;
    do {
        ring.insert(topology.cell(h));
        h = topology.next_around_vertex(h);
    } while (h != start && ring.size() <= 6);
    EXPECT_EQ(ring, (std::multiset<Index>{0, 0, 0, 1, 1, 1}));
}

} // namespace
} // namespace ciel::test
