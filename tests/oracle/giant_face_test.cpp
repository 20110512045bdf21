// Faces with thousands of corners and vertices with thousands of edges. No time is measured: an algorithm of quadratic
// time would not end here.
#include "blocks/blocks.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ciel::test {
namespace {

constexpr Id sides = 100'000;

Point on_circle(Id i, double z) {
    const double angle = 2 * 3.14159265358979323846 * i / sides;
    return {100 * std::cos(angle), 100 * std::sin(angle), z};
}

// One cell with `sides` walls, and a floor and roof of `sides` corners.
Polyhedra prism() {
    Polyhedra mesh;
    std::vector<Loop> faces(2);
    for (const double z : {0.0, 1.0})
        for (Id i = 0; i < sides; ++i) mesh.add_vertex(on_circle(i, z));
    for (Id i = 0; i < sides; ++i) {
        const Id next = (i + 1) % sides;
        faces[0].push_back(sides - 1 - i);
        faces[1].push_back(sides + i);
        faces.push_back({i, next, sides + next, sides + i});
    }
    mesh.add_cell(polyhedron, faces);
    return mesh;
}

// One cell whose triangles all meet at one of two apexes. The apexes have the lowest vertex ids or the highest, which
// decides the direction of their edges.
Polyhedra spindle(bool apexes_first) {
    Polyhedra mesh;
    if (apexes_first) mesh.add_vertex({0, 0, -1}), mesh.add_vertex({0, 0, 1});
    for (Id i = 0; i < sides; ++i) mesh.add_vertex(on_circle(i, 0));
    if (!apexes_first) mesh.add_vertex({0, 0, -1}), mesh.add_vertex({0, 0, 1});
    const Id rim = apexes_first ? 2 : 0, bottom = apexes_first ? 0 : sides, top = bottom + 1;
    std::vector<Loop> faces;
    for (Id i = 0; i < sides; ++i) {
        const Id here = rim + i, next = rim + (i + 1) % sides;
        faces.push_back({bottom, next, here});
        faces.push_back({top, here, next});
    }
    mesh.add_cell(polyhedron, faces);
    return mesh;
}

// `sides` tetrahedra around one edge.
Polyhedra ring_of_tetrahedra() {
    Polyhedra mesh;
    mesh.add_vertex({0, 0, -1});
    mesh.add_vertex({0, 0, 1});
    for (Id i = 0; i < sides; ++i) mesh.add_vertex(on_circle(i, 0));
    for (Id i = 0; i < sides; ++i) {
        const Id here = 2 + i, next = 2 + (i + 1) % sides;
        mesh.add_cell(tetrahedron, {{0, next, here}, {1, here, next}, {0, here, 1}, {0, 1, next}});
    }
    return mesh;
}

void expect_operators_hold(const Topology& topology) {
    std::uint64_t half_edges = 0;
    for (Index cell = 0; cell < topology.counts().cells; ++cell) {
        for (const HalfEdge h : topology.half_edges(cell)) {
            ++half_edges;
            const HalfEdge mate = topology.mate_face(h);
            ASSERT_NE(mate, h);
            ASSERT_EQ(topology.mate_face(mate), h);
            ASSERT_EQ(topology.edge(mate), topology.edge(h));
            ASSERT_NE(topology.vertex(mate), topology.vertex(h));
            ASSERT_EQ(topology.vertex(topology.mate_face(topology.next_around_face(h))), topology.vertex(h));
        }
    }
    ASSERT_EQ(half_edges, topology.counts().half_edges);
}

// Cuts at height z with every algorithm, and expects the given numbers of polygons and points.
void expect_polygon(const KernelMesh& mesh, double z, std::size_t polygons, std::size_t points) {
    const Field height = make_field(mesh.topology, plane_distance(mesh.mesh(), {0, 0, 0}, {0, 0, 1}));
    for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation, Algorithm::naive}) {
        Query query = mesh.query(algorithm);
        query.set_field(height);
        Surface surface;
        ASSERT_TRUE(query.extract(z, false, surface));
        EXPECT_EQ(surface.polygon_cell.size(), polygons);
        EXPECT_EQ(surface.points.size(), points);
        EXPECT_FALSE(triangulate(surface).empty());
    }
}

TEST(GiantFace, APrism) {
    const KernelMesh mesh(prism());
    ASSERT_TRUE(mesh.assembled.report.bad_cells.empty());
    EXPECT_EQ(mesh.topology.counts().half_edges, 6ULL * sides);
    EXPECT_EQ(mesh.topology.counts().edges, 3ULL * sides);
    expect_operators_hold(mesh.topology);
    expect_polygon(mesh, 0.25, 1, sides);
}

TEST(GiantFace, ASpindleOfTwoApexes) {
    for (const bool apexes_first : {true, false}) {
        const KernelMesh mesh(spindle(apexes_first));
        ASSERT_TRUE(mesh.assembled.report.bad_cells.empty());
        EXPECT_EQ(mesh.topology.counts().half_edges, 6ULL * sides);
        EXPECT_EQ(mesh.topology.counts().edges, 3ULL * sides);
        expect_operators_hold(mesh.topology);
        expect_polygon(mesh, 0.25, 1, sides);
    }
}

// Face windings are reversed at random. assemble() has to make them consistent.
TEST(GiantFace, ASpindleWithTurnedFaces) {
    const KernelMesh mesh(with_turned_faces(spindle(true), 0.5, 3));
    ASSERT_TRUE(mesh.assembled.report.bad_cells.empty());
    expect_operators_hold(mesh.topology);
    expect_polygon(mesh, 0.25, 1, sides);
}

TEST(GiantFace, ASpindleThatLacksATriangleIsOpen) {
    Polyhedra mesh = spindle(true);
    mesh.face_offset.pop_back();
    mesh.face_vertex.resize(mesh.face_offset.back());
    mesh.cell_offset.back() -= 1;
    const Assembled assembled = assemble(view(mesh));
    ASSERT_EQ(assembled.report.bad_cells.size(), 1U);
    EXPECT_EQ(assembled.report.bad_cells[0].reason, BadCells::Reason::open);
}

TEST(GiantFace, ARingOfTetrahedraInBlocksOfOne) {
    const KernelMesh mesh(ring_of_tetrahedra(), {1});
    EXPECT_EQ(mesh.topology.counts().half_edges, 12ULL * sides);
    EXPECT_EQ(mesh.topology.counts().edges, 3ULL * sides + 1);
    expect_operators_hold(mesh.topology);
    expect_polygon(mesh, 0.25, sides, sides + 1ULL);
}

// The search for a mate takes at most `longest_search` steps, for cells and faces of any size; otherwise the mate is
// stored.
TEST(GiantFace, AMateIsFoundInAFewStepsOrListed) {
    for (const Polyhedra& input : {prism(), spindle(true), giant_cell(56)}) {
        const KernelMesh mesh(input);
        const Topology::Blocks& blocks = mesh.topology.blocks();
        for (Index b = 0; b < blocks.count(); ++b)
            detail::with_mates(blocks.cells(b), blocks.mates(b), [&](const auto& polyhedra, const auto& mates) {
                for (Index h = 0; h < polyhedra.vertex.size() + polyhedra.inner_corners; ++h) {
                    const Index bits = mates.mate_bits(h);
                    if (bits == mates.escape) continue;
                    const Index k = polyhedra.corner(h), own = polyhedra.face(k);
                    const auto faces = polyhedra.faces_of(polyhedra.face_cell[own][polyhedra.side(h)]);
                    std::size_t steps = 0;
                    bool found = false;
                    for (Index i = bits; i < faces.size() && !found; i += mates.escape) {
                        const Index other = faces[i] / 2;
                        for (Index at = polyhedra.face_begin[other];
                             at < polyhedra.face_begin[other + 1] && other != own && !found; ++at, ++steps)
                            found = polyhedra.edge[at] == polyhedra.edge[k];
                    }
                    ASSERT_TRUE(found);
                    ASSERT_LE(steps, mates.longest_search);
                }
            });
    }
}

} // namespace
} // namespace ciel::test
