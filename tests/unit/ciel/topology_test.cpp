#include "unit/ciel/meshes.hpp"

#include "ciel/topology.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace ciel::test {
namespace {

std::vector<HalfEdge> all_half_edges(const Topology& topology) {
    std::vector<HalfEdge> out;
    for (Index c = 0; c < topology.counts().cells; ++c)
        for (const HalfEdge h : topology.half_edges(c)) out.push_back(h);
    return out;
}

Index origin(const Topology& topology, HalfEdge h) { return topology.vertex(topology.mate_face(h)); }

// Checks the identities of the six operators, and their results against the mesh's arrays.
void expect_identities(const FaceMesh& mesh, const Topology& topology) {
    const std::vector<HalfEdge> all = all_half_edges(topology);
    const std::set<HalfEdge> ids(all.begin(), all.end());
    ASSERT_EQ(ids.size(), all.size());
    ASSERT_EQ(all.size(), topology.counts().half_edges);
    std::map<Index, std::pair<Index, Index>> ends;
    std::map<std::pair<Index, Index>, Index> edges;
    std::map<Index, std::set<HalfEdge>> leaving;
    std::size_t on_boundary = 0;
    for (const HalfEdge h : all) {
        const HalfEdge mate = topology.mate_face(h);
        ASSERT_TRUE(ids.contains(mate));
        ASSERT_NE(mate, h);
        ASSERT_EQ(topology.mate_face(mate), h);
        ASSERT_EQ(topology.cell(mate), topology.cell(h));
        ASSERT_EQ(topology.edge(mate), topology.edge(h));
        ASSERT_NE(topology.vertex(mate), topology.vertex(h));

        const HalfEdge next = topology.next_around_face(h);
        ASSERT_EQ(topology.cell(next), topology.cell(h));
        ASSERT_EQ(origin(topology, next), topology.vertex(h));
        std::size_t turns = 1;
        for (HalfEdge g = next; g != h; g = topology.next_around_face(g)) ASSERT_LE(++turns, 100U);

        const HalfEdge other = topology.mate_polyhedron(h);
        if (other == no_half_edge) {
            ++on_boundary;
        } else {
            ASSERT_EQ(topology.mate_polyhedron(other), h);
            ASSERT_NE(topology.cell(other), topology.cell(h));
            ASSERT_EQ(topology.edge(other), topology.edge(h));
            ASSERT_EQ(topology.vertex(other), origin(topology, h));
            ASSERT_EQ(topology.mate_polyhedron(next), [&] { // the mates run in the opposite direction around the face
                HalfEdge before = other;
                while (topology.next_around_face(before) != other) before = topology.next_around_face(before);
                return before;
            }());
        }
        const std::pair<Index, Index> pair = std::minmax(origin(topology, h), topology.vertex(h));
        ASSERT_EQ(ends.emplace(topology.edge(h), pair).first->second, pair);
        ASSERT_EQ(edges.emplace(pair, topology.edge(h)).first->second, topology.edge(h));
        leaving[origin(topology, h)].insert(h);
    }
    EXPECT_EQ(edges.size(), topology.counts().edges);
    EXPECT_TRUE(ends.empty() || ends.rbegin()->first == topology.counts().edges - 1);
    std::size_t boundary_corners = 0;
    std::set<std::pair<Index, Index>> seen;
    Index next_edge = 0;
    for (Index f = 0; f < mesh.owner.size(); ++f) {
        const auto loop = mesh.view().loop(f);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const std::pair<Index, Index> pair = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
            if (pair.first == pair.second) continue;
            boundary_corners += mesh.neighbour[f] == none ? 1 : 0;
            if (!seen.insert(pair).second) continue;
            ASSERT_EQ(edges.at(pair), next_edge++); // edges are numbered by first appearance
        }
    }
    EXPECT_EQ(on_boundary, boundary_corners);
    for (const auto& [vertex, expected] : leaving) {
        std::set<HalfEdge> found;
        const HalfEdge start = topology.half_edge_of_vertex(vertex);
        HalfEdge h = start;
        do {
            ASSERT_TRUE(found.insert(h).second);
            h = topology.next_around_vertex(h);
        } while (h != start);
        ASSERT_EQ(found, expected) << "vertex " << vertex;
    }
}

TEST(Topology, OperatorsAreIdentitiesForAnyMeshAndBlockSize) {
    for (const NamedMesh& m : all_meshes())
        for (const Index size : {1U, 2U, 7U, 64U, 100000U}) {
            SCOPED_TRACE(m.name + " in blocks of " + std::to_string(size));
            const Topology topology(m.mesh.view(), {size});
            expect_identities(m.mesh, topology);
            if (testing::Test::HasFatalFailure()) return;
        }
}

TEST(Topology, CountsWhatIsThere) {
    const auto counts = [](const Polyhedra& mesh) { return Topology(shared_view(mesh.assembled().mesh)).counts(); };
    const TopologyCounts cube = counts(hexahedra(2, 2, 2));
    EXPECT_EQ(cube.vertices, 27U);
    EXPECT_EQ(cube.edges, 54U);
    EXPECT_EQ(cube.faces, 36U);
    EXPECT_EQ(cube.boundary_faces, 24U);
    EXPECT_EQ(cube.half_edges, 192U);
    EXPECT_EQ(cube.components, 1U);
    EXPECT_EQ(counts(cubes_that_share_an_edge()).components, 2U);
    EXPECT_EQ(counts(cubes_that_share_an_edge()).edges, 23U);
    EXPECT_EQ(counts(hollow_box()).components, 1U);
    const TopologyCounts wedges = counts(collapsed_hexahedra(6)); // Euler: V - E + F - C = 1
    EXPECT_EQ(wedges.vertices, 2U + 24U);
    EXPECT_EQ(wedges.edges, 1U + 2 * 6U + 2 * 12U + 2 * 6U + 12U);
}

// A cell of 70,000 half-edges needs 32-bit local ids.
TEST(Topology, TakesAGiantCell) {
    Polyhedra mesh;
    constexpr Index sides = 13000;
    for (int k = 0; k <= 1; ++k)
        for (Index i = 0; i < sides; ++i)
            mesh.vertex(std::cos(6.283185307 * i / sides), std::sin(6.283185307 * i / sides), k);
    std::vector<Index> low(sides), high(sides);
    std::vector<std::vector<Index>> faces;
    for (Index i = 0; i < sides; ++i) {
        low[sides - 1 - i] = i;
        high[i] = sides + i;
        faces.push_back({i, (i + 1) % sides, sides + (i + 1) % sides, sides + i});
    }
    faces.push_back(low);
    faces.push_back(high);
    mesh.polyhedron(faces);
    const Index apex = mesh.vertex(3, 0, 0.5);
    mesh.polyhedron(
        {{0, sides, sides + 1, 1}, {apex, sides, 0}, {apex, sides + 1, sides}, {apex, 1, sides + 1}, {apex, 0, 1}});
    const FaceMesh stored = mesh.assembled().mesh;
    const Topology topology(stored.view());
    EXPECT_EQ(topology.counts().half_edges, 6U * sides + 16);
    EXPECT_EQ(topology.counts().edges, 3U * sides + 4);
    for (Index c = 0; c < 2; ++c)
        for (const HalfEdge h : topology.half_edges(c)) {
            ASSERT_EQ(topology.mate_face(topology.mate_face(h)), h);
            ASSERT_EQ(topology.edge(topology.mate_face(h)), topology.edge(h));
            const HalfEdge other = topology.mate_polyhedron(h);
            ASSERT_TRUE(other == no_half_edge || topology.mate_polyhedron(other) == h);
        }
}

TEST(Topology, RefusesADamagedMesh) {
    const FaceMesh good = hexahedra(2, 1, 1).assembled().mesh;
    const std::pair<const char*, std::function<void(FaceMesh&)>> rows[] = {
        {"vertex id", [](FaceMesh& m) { m.face_vertex[3] = 12; }},
        {"positions", [](FaceMesh& m) { m.positions.pop_back(); }},
        {"owner order", [](FaceMesh& m) { std::swap(m.owner.front(), m.owner.back()); }},
        {"owner range", [](FaceMesh& m) { m.owner.back() = 2; }},
        {"neighbour range", [](FaceMesh& m) { m.neighbour[0] = 2; }},
        {"neighbour order", [](FaceMesh& m) { m.neighbour[0] = 0; }},
        {"lengths", [](FaceMesh& m) { m.neighbour.pop_back(); }},
        {"offsets", [](FaceMesh& m) { m.face_offset[2] = 99; }},
        {"offsets' length", [](FaceMesh& m) { m.face_offset.pop_back(); }},
        {"no offsets", [](FaceMesh& m) { m.face_offset.clear(); }},
        {"open cell", [](FaceMesh& m) { m.neighbour[0] = none; }},
    };
    for (const auto& [name, spoil] : rows) {
        SCOPED_TRACE(name);
        FaceMesh mesh = good;
        spoil(mesh);
        EXPECT_THROW(Topology(mesh.view(), {1}), Error);
    }
}

TEST(Topology, StaysWithinTheBytesPerHalfEdgeItPromises) {
    const std::pair<FaceMesh, double> rows[] = {{hexahedra(20, 20, 20).assembled().mesh, 16.0},
                                                {hexagonal_prisms(20, 20, 20).assembled().mesh, 16.0}};
    for (const auto& [mesh, limit] : rows) {
        const Topology topology(mesh.view());
        EXPECT_LT(static_cast<double>(topology.memory_bytes()),
                  limit * static_cast<double>(topology.counts().half_edges));
    }
}

} // namespace
} // namespace ciel::test
