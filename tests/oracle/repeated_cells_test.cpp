// Meshes that list cells more than once: the surface is that of the mesh without the copies, and the copies are
// reported.
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace ciel::test {
namespace {

using Reason = BadCells::Reason;

// A cell that collapsed to one of its faces, as at the poles of curvilinear grids, has that face twice. It is no copy
// of another cell.
bool has_a_face_twice(const Polyhedra& mesh, Id cell) {
    std::vector<std::vector<Id>> faces;
    for (const Loop& loop : mesh.loops(cell)) {
        Loop corners = without_repeats(loop);
        if (corners.size() < 3) continue;
        std::ranges::sort(corners);
        faces.push_back(corners);
    }
    std::ranges::sort(faces);
    return faces.empty() || std::ranges::adjacent_find(faces) != faces.end();
}

// The same faces in random order, with random first corners and windings.
std::vector<Loop> disguised(std::vector<Loop> loops, std::mt19937_64& random) {
    std::ranges::shuffle(loops, random);
    for (Loop& loop : loops) {
        std::ranges::rotate(loop, loop.begin() + static_cast<std::ptrdiff_t>(random() % loop.size()));
        if (random() % 2 == 0) std::ranges::reverse(loop);
    }
    return loops;
}

class RepeatedCells : public testing::TestWithParam<NamedMesh> {
protected:
    Polyhedra once = GetParam().make();

    // Appends `often` copies of a `share` of the cells, and expects the surface of the mesh without copies.
    void expect_as_if_listed_once(double share, int often) {
        std::mt19937_64 random(5);
        Polyhedra repeated = once;
        for (int round = 0; round < often; ++round)
            for (Id cell = 0; cell < once.cell_count(); ++cell)
                if (!has_a_face_twice(once, cell) && static_cast<double>(random() % 1000) < 1000 * share)
                    repeated.add_cell(polyhedron, disguised(once.loops(cell), random));
        const Id copies = repeated.cell_count() - once.cell_count();
        const KernelMesh mesh(repeated, {32}), expected(once, {32});
        const AssembleReport& report = mesh.assembled.report;
        ASSERT_EQ(report.bad_cells.size(), copies > 0 ? 1U : 0U);
        if (copies > 0) {
            EXPECT_EQ(report.bad_cells[0].reason, Reason::repeated);
            EXPECT_EQ(report.bad_cells[0].count, copies);
            EXPECT_EQ(report.bad_cells[0].first_ids.front(), once.cell_count());
        }
        EXPECT_EQ(report.internal_boundaries, expected.assembled.report.internal_boundaries);
        EXPECT_EQ(report.inverted_cells, expected.assembled.report.inverted_cells);
        EXPECT_EQ(mesh.assembled.original_cell, expected.assembled.original_cell);
        EXPECT_EQ(mesh.assembled.mesh.neighbour, expected.assembled.mesh.neighbour);
        const std::vector<float> values = random_field(once.vertex_count(), 3);
        const Field field = make_field(mesh.topology, mesh.stored(values));
        Query query = mesh.query();
        query.set_field(field);
        Surface surface;
        for (const double nu : {0.2, 0.5, 0.8}) {
            ASSERT_TRUE(query.extract(nu, false, surface));
            const Cut cut = mesh.cut(surface);
            EXPECT_EQ(difference(cut_every_cell(once, values, nu), cut), "");
            EXPECT_EQ(open_segment(polygon_segments(cut.polygons), boundary_segments(once, values, nu)), "");
        }
    }
};

TEST_P(RepeatedCells, OneInThree) { expect_as_if_listed_once(0.33, 1); }
TEST_P(RepeatedCells, AllOfThemTwice) { expect_as_if_listed_once(1, 1); }
TEST_P(RepeatedCells, SomeManyTimes) { expect_as_if_listed_once(0.3, 4); }

INSTANTIATE_TEST_SUITE_P(All, RepeatedCells, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

// Copies beside each other in the file, as from a parallel run in which two partitions write their border cells.
TEST(RepeatedCell, TheFirstOneIsKept) {
    const Polyhedra row = hexahedra({{4, 1, 1}});
    Polyhedra mesh = keep_cells(row, [](Id) { return false; });
    for (const Id cell : {2U, 0U, 0U, 1U, 2U, 3U, 0U}) mesh.add_cell(hexahedron, row.loops(cell));
    const Assembled assembled = assemble(view(mesh));
    ASSERT_EQ(assembled.report.bad_cells.size(), 1U);
    EXPECT_EQ(assembled.report.bad_cells[0].reason, Reason::repeated);
    EXPECT_THAT(assembled.report.bad_cells[0].first_ids, testing::ElementsAre(2U, 4U, 6U));
    EXPECT_THAT(assembled.original_cell, testing::UnorderedElementsAre(0U, 1U, 3U, 5U));
    EXPECT_EQ(assembled.mesh.owner.size(), 4U * 5 + 1);
    EXPECT_EQ(std::ranges::count(assembled.mesh.neighbour, none), 18);
}

// Two different cells share all faces except one. Faces with three cells make a bad mesh, but neither cell is a copy.
TEST(RepeatedCell, NeighboursThatShareAllFacesButOneStay) {
    Polyhedra mesh = hexahedra({{1, 1, 1}});
    const Id roof = mesh.add_vertex({0.5, 0.5, 2});
    std::vector<Loop> house = mesh.loops(0);
    const auto top = std::ranges::find_if(house, [&](const Loop& loop) {
        return std::ranges::all_of(loop, [&](Id v) { return mesh.position(v)[2] == 1; });
    });
    ASSERT_NE(top, house.end());
    const Loop eaves = *top;
    house.erase(top);
    for (std::size_t i = 0; i < 4; ++i) house.push_back({eaves[i], eaves[(i + 1) % 4], roof});
    mesh.add_cell(polyhedron, house);
    const Assembled assembled = assemble(view(mesh));
    EXPECT_TRUE(assembled.report.bad_cells.empty());
    EXPECT_EQ(assembled.original_cell.size(), 2U);
}

} // namespace
} // namespace ciel::test
