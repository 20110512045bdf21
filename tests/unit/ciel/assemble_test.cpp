#include "unit/ciel/meshes.hpp"

#include "support/thread_count.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <set>

namespace ciel::test {
namespace {

using Reason = BadCells::Reason;

// Checks the contract of FaceMeshView, and that every cell is closed with faces that point outwards.
void expect_sound(const FaceMesh& mesh) {
    const FaceMeshView view = mesh.view();
    ASSERT_EQ(view.face_offset.size(), view.face_count() + 1);
    ASSERT_TRUE(std::ranges::is_sorted(mesh.owner));
    std::vector<std::multiset<std::pair<Index, Index>>> half_edges(view.cell_count());
    std::vector<double> volume(view.cell_count(), 0.0);
    for (Index f = 0; f < view.face_count(); ++f) {
        ASSERT_LT(mesh.owner[f], mesh.neighbour[f]);
        const auto loop = view.loop(f);
        double cones = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Index a = loop[i], b = loop[(i + 1) % loop.size()];
            ASSERT_LT(a, view.vertex_count());
            if (a == b) continue;
            half_edges[mesh.owner[f]].emplace(a, b);
            if (mesh.neighbour[f] != none) half_edges[mesh.neighbour[f]].emplace(b, a);
        }
        const auto p = [&](std::size_t i) { return &mesh.positions[3 * std::size_t{loop[i]}]; };
        for (std::size_t i = 2; i < loop.size(); ++i) {
            const float *a = p(0), *b = p(i - 1), *c = p(i);
            cones += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                     a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
        volume[mesh.owner[f]] += cones / 6;
        if (mesh.neighbour[f] != none) volume[mesh.neighbour[f]] -= cones / 6;
    }
    for (Index c = 0; c < view.cell_count(); ++c) {
        EXPECT_GT(volume[c], 0) << "cell " << c;
        for (const auto& [a, b] : half_edges[c])
            ASSERT_EQ(half_edges[c].count({a, b}), half_edges[c].count({b, a})) << "cell " << c << " is open";
    }
}

std::size_t boundary_faces(const FaceMesh& mesh) {
    return static_cast<std::size_t>(std::ranges::count(mesh.neighbour, none));
}

struct Row {
    const char* name;
    Polyhedra mesh;
    std::size_t cells, faces, boundary;
};

TEST(Assemble, MatchesTheFacesOfEveryKindOfMesh) {
    const Row rows[] = {
        {"tetrahedron", one_tetrahedron(), 1, 4, 4},
        {"hexahedra", hexahedra(3, 2, 2), 12, 4 * 4 + 3 * 3 * 2 + 3 * 2 * 3, 32},
        {"tetrahedra", tetrahedra(2, 2, 2), 48, (48 * 4 + 48) / 2, 48},
        {"hanging nodes", hanging_nodes(), 5, 9 + 4 * 6 - 4 - 4, 5 + 12},
        {"mixed cells", mixed_cells(), 5, 6 + 5 + 5 + 4 + 5 - 5, 15},
        {"collapsed", collapsed_hexahedra(8), 16, 8 * (2 * 6 - 1 - 2), 8 * (5 + 1)},
        {"shared edge", cubes_that_share_an_edge(), 2, 12, 12},
        {"hollow", hollow_box(), 26, 108, 60},
        {"pinched", pinched_cell(), 3, 20, 16},
        {"cell around a cell", cell_around_a_cell(), 2, 60, 54},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        const Assembled out = row.mesh.assembled();
        EXPECT_TRUE(out.report.bad_cells.empty());
        EXPECT_EQ(out.mesh.cell_types.size(), row.cells);
        EXPECT_EQ(out.mesh.owner.size(), row.faces);
        EXPECT_EQ(boundary_faces(out.mesh), row.boundary);
        expect_sound(out.mesh);
    }
}

TEST(Assemble, TurnsAnyWindingOutwards) {
    std::mt19937 random(7);
    for (const Polyhedra& good : {hexahedra(3, 3, 3), tetrahedra(2, 2, 2), hexagonal_prisms(4, 3, 2), mixed_cells(),
                                  pinched_cell(), cell_around_a_cell()}) {
        for (int round = 0; round < 10; ++round) {
            Polyhedra mesh = good;
            for (std::size_t f = 0; f + 1 < mesh.face_offset.size(); ++f)
                if (random() % 2 != 0)
                    std::reverse(mesh.face_vertex.begin() + static_cast<std::ptrdiff_t>(mesh.face_offset[f]),
                                 mesh.face_vertex.begin() + static_cast<std::ptrdiff_t>(mesh.face_offset[f + 1]));
            const Assembled out = mesh.assembled();
            EXPECT_TRUE(out.report.bad_cells.empty());
            EXPECT_GT(out.report.reversed_faces, 0U);
            EXPECT_EQ(out.report.inverted_cells, 0U);
            EXPECT_EQ(out.report.internal_boundaries, 0U);
            EXPECT_EQ(out.mesh.owner.size(), good.assembled().mesh.owner.size());
            expect_sound(out.mesh);
        }
    }
}

TEST(Assemble, TurnsAMirroredMesh) {
    Polyhedra mesh = hexahedra(2, 2, 2);
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) mesh.positions[i] *= -1;
    const Assembled out = mesh.assembled();
    EXPECT_EQ(out.report.reversed_cells, 8U);
    EXPECT_EQ(out.report.reversed_faces, 0U);
    expect_sound(out.mesh);
}

TEST(Assemble, KeepsAFoldedCellWoundLikeItsNeighbours) {
    Polyhedra mesh = hexahedra(3, 3, 3);
    for (int k = 1; k <= 2; ++k)
        for (int j = 1; j <= 2; ++j) // swaps the left and right sides of the middle cell
            std::swap(mesh.positions[3 * static_cast<std::size_t>((k * 4 + j) * 4 + 1)],
                      mesh.positions[3 * static_cast<std::size_t>((k * 4 + j) * 4 + 2)]);
    const Assembled out = mesh.assembled();
    EXPECT_EQ(out.report.inverted_cells, 1U);
    EXPECT_THAT(out.report.first_inverted, testing::ElementsAre(13));
    EXPECT_EQ(boundary_faces(out.mesh), 54U);
}

TEST(Assemble, LeavesBadCellsOutAndNamesThem) {
    struct Bad {
        const char* name;
        std::function<void(Polyhedra&)> spoil;
        Reason reason;
    };
    const Bad rows[] = {
        {"a face is missing",
         [](Polyhedra& m) {
             m.polyhedron({{0, 1, 3, 2}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 6, 4}});
         },
         Reason::open},
        {"index out of range",
         [](Polyhedra& m) {
             m.polyhedron({{0, 1, 3}, {0, 1, 99}, {1, 3, 99}, {3, 0, 99}});
         },
         Reason::index_out_of_range},
        {"three faces",
         [](Polyhedra& m) {
             m.polyhedron({{0, 1, 3}, {0, 1, 5}, {1, 3, 5}});
         },
         Reason::too_few_faces},
        {"projective plane",
         [](Polyhedra& m) {
             m.polyhedron({{0, 1, 2},
                           {0, 2, 3},
                           {0, 3, 4},
                           {0, 4, 5},
                           {0, 5, 1},
                           {1, 2, 4},
                           {2, 3, 5},
                           {3, 4, 1},
                           {4, 5, 2},
                           {5, 1, 3}});
         },
         Reason::inconsistent_winding},
        {"not a number",
         [](Polyhedra& m) {
             const Index v = m.vertex(std::numeric_limits<double>::quiet_NaN(), 0, 0);
             m.cell(CellType::tetrahedron, {0, 1, 2, v});
         },
         Reason::inside_out_unresolved},
    };
    for (const Bad& row : rows) {
        SCOPED_TRACE(row.name);
        Polyhedra mesh = hexahedra(2, 1, 1);
        row.spoil(mesh);
        const Assembled out = mesh.assembled();
        ASSERT_EQ(out.report.bad_cells.size(), 1U);
        EXPECT_EQ(out.report.bad_cells[0].reason, row.reason);
        EXPECT_EQ(out.report.bad_cells[0].count, 1U);
        EXPECT_THAT(out.report.bad_cells[0].first_ids, testing::ElementsAre(2));
        EXPECT_EQ(out.mesh.cell_types.size(), 2U);
        EXPECT_EQ(boundary_faces(out.mesh), 10U);
        expect_sound(out.mesh);
    }
}

TEST(Assemble, LeavesOutFacesOfFewerThanThreeVerticesAndKeepsTheCellThatOthersClose) {
    Polyhedra mesh = hexahedra(2, 1, 1);
    const Index top = mesh.vertex(0.5, 0.5, 2);
    mesh.polyhedron({{4, 5}, {4, 5, 7, 6}, {4, top, 5}, {}, {5, top, 7}, {7, top, 6}, {99}, {6, top, 4}});
    mesh.polyhedron({{0, 1, 3, 2}, {0, 1, 5, 4}, {0, 1}, {4, 5, 7, 6}, {0, 2, 6, 4}});
    const Assembled out = mesh.assembled();
    EXPECT_EQ(out.report.short_faces, 3U);
    EXPECT_THAT(out.report.first_short, testing::ElementsAre(2));
    ASSERT_EQ(out.report.bad_cells.size(), 1U);
    EXPECT_EQ(out.report.bad_cells[0].reason, Reason::open);
    EXPECT_THAT(out.report.bad_cells[0].first_ids, testing::ElementsAre(3));
    EXPECT_EQ(out.mesh.cell_types.size(), 3U);
    for (Index f = 0; f < out.mesh.view().face_count(); ++f) EXPECT_GE(out.mesh.view().loop(f).size(), 3U);
    expect_sound(out.mesh);
}

TEST(Assemble, RefusesArraysThatDoNotFitTogether) {
    Polyhedra mesh = hexahedra(1, 1, 1);
    mesh.positions.pop_back();
    EXPECT_THROW(static_cast<void>(mesh.assembled()), Error);
    mesh = hexahedra(1, 1, 1);
    mesh.types[0] = 99;
    EXPECT_THROW(static_cast<void>(mesh.assembled()), Error);
    mesh = hexahedra(1, 1, 1);
    mesh.cell_offset.pop_back();
    EXPECT_THROW(static_cast<void>(mesh.assembled()), Error);
    mesh = hexahedra(1, 1, 1);
    std::swap(mesh.face_offset[1], mesh.face_offset[2]);
    EXPECT_THROW(static_cast<void>(mesh.assembled()), Error);
    mesh = hexahedra(1, 1, 1);
    mesh.face_vertex.pop_back();
    EXPECT_THROW(static_cast<void>(mesh.assembled()), Error);
}

TEST(Assemble, LeavesAFaceOfThreeCellsUnmatched) {
    Polyhedra mesh = hexahedra(2, 1, 1);
    const Index apex = mesh.vertex(0.4, 0.5, 0.5);
    mesh.cell(CellType::pyramid, {1, 4, 10, 7, apex}); // its base is the face between the two cells
    const Assembled out = mesh.assembled();
    EXPECT_EQ(out.report.internal_boundaries, 1U);
    EXPECT_EQ(boundary_faces(out.mesh), 10U + 3U + 4U);
}

TEST(Assemble, StringsACollapsedCellBetweenItsNeighbours) {
    Polyhedra mesh = hexahedra(1, 1, 2);
    mesh.cell(CellType::hexahedron, {4, 5, 7, 6, 4, 5, 7, 6});
    const Assembled out = mesh.assembled();
    EXPECT_TRUE(out.report.bad_cells.empty());
    EXPECT_EQ(out.report.internal_boundaries, 0U);
    EXPECT_EQ(out.mesh.cell_types.size(), 3U);
    EXPECT_EQ(out.mesh.owner.size(), 10U + 4U + 2U); // four faces of the flat cell collapsed to lines
    EXPECT_EQ(boundary_faces(out.mesh), 14U);
}

TEST(Assemble, NumbersVerticesByFirstUseAndDropsUnusedOnes) {
    Polyhedra mesh = hexahedra(4, 4, 4);
    mesh.vertex(9, 9, 9);
    const Assembled out = mesh.assembled();
    EXPECT_EQ(out.original_vertex.size(), 125U);
    Index next = 0;
    for (const Index v : out.mesh.face_vertex) {
        ASSERT_LE(v, next);
        next = std::max(next, v + 1);
    }
    const FaceMeshView stored_mesh = out.mesh.view();
    for (Index f = 0; f < stored_mesh.face_count(); ++f) {
        std::set<Index> stored;
        for (const Index v : stored_mesh.loop(f)) stored.insert(out.original_vertex[v]);
        const Index owner = out.original_cell[stored_mesh.owner[f]];
        bool is_found = false;
        for (std::uint64_t source = mesh.cell_offset[owner]; source < mesh.cell_offset[owner + 1]; ++source)
            is_found = is_found || stored == std::set<Index>(mesh.face_vertex.begin() + mesh.face_offset[source],
                                                             mesh.face_vertex.begin() + mesh.face_offset[source + 1]);
        ASSERT_TRUE(is_found) << "face " << f;
    }
}

TEST(Assemble, PutsCellsInAnOrderWhereNeighboursAreClose) {
    const Assembled out = hexahedra(8, 8, 8).assembled();
    std::vector<Index> sorted = out.original_cell;
    // In a cube of a power of two, consecutive cells on the curve are neighbors.
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        const auto at = [&](std::size_t n) { return std::array{sorted[n] % 8, sorted[n] / 8 % 8, sorted[n] / 64}; };
        int steps = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            steps += std::abs(static_cast<int>(at(i)[axis]) - static_cast<int>(at(i - 1)[axis]));
        ASSERT_EQ(steps, 1);
    }
    std::ranges::sort(sorted);
    std::vector<Index> all(512);
    std::iota(all.begin(), all.end(), 0U);
    EXPECT_EQ(sorted, all);
}

TEST(Assemble, IsTheSameOnAnyNumberOfThreads) {
    const Polyhedra mesh = tetrahedra(12, 12, 12);
    const Assembled serial = [&] {
        const ThreadCount one(1);
        return mesh.assembled();
    }();
    const Assembled parallel = mesh.assembled();
    EXPECT_EQ(serial.mesh.face_vertex, parallel.mesh.face_vertex);
    EXPECT_EQ(serial.mesh.neighbour, parallel.mesh.neighbour);
    EXPECT_EQ(serial.original_cell, parallel.original_cell);
}

TEST(Assemble, TakesNothing) {
    const Assembled out = assemble(Polyhedra{}.view());
    EXPECT_EQ(out.mesh.view().face_count(), 0U);
    EXPECT_EQ(out.mesh.view().cell_count(), 0U);
}

TEST(StandardCells, RefuseAWrongNumberOfCorners) {
    Polyhedra mesh;
    EXPECT_THROW(mesh.cell(CellType::wedge, {0, 1, 2}), Error);
    EXPECT_THROW(mesh.cell(CellType::polyhedron, {0, 1, 2, 3}), Error);
}

} // namespace
} // namespace ciel::test
