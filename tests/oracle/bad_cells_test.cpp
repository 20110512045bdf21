// Input that assemble() must refuse: single cells where possible, otherwise the whole mesh.
#include "ciel/assemble.hpp"
#include "ciel/topology.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace ciel::test {
namespace {

using Reason = BadCells::Reason;
using testing::HasSubstr;

Polyhedra cubes() { return hexahedra({{4, 1, 1}}); } // cells 0 to 3 in a row

// The row of cells, with the faces of one cell changed by `change`.
Polyhedra with_cell(Id cell, const std::function<void(std::vector<Loop>&)>& change) {
    const Polyhedra row = cubes();
    Polyhedra result = keep_cells(row, [](Id) { return false; });
    for (Id c = 0; c < row.cell_count(); ++c) {
        std::vector<Loop> loops = row.loops(c);
        if (c == cell) change(loops);
        result.add_cell(c == cell ? polyhedron : hexahedron, loops);
    }
    return result;
}

// The projective plane on six vertices: closed, two triangles at each edge, and not orientable.
const std::vector<Loop> one_sided{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                                  {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};

struct BadCase {
    const char* name;
    std::function<void(std::vector<Loop>&)> change;
    Reason reason;
};

std::ostream& operator<<(std::ostream& out, const BadCase& bad) { return out << bad.name; }

const float nan = std::nanf("");

class BadCell : public testing::TestWithParam<BadCase> {};

TEST_P(BadCell, IsNamedLeftOutAndItsNeighboursFacesBecomeBoundary) {
    for (Id cell : {0U, 2U}) {
        const Assembled assembled = assemble(view(with_cell(cell, GetParam().change)));
        ASSERT_EQ(assembled.report.bad_cells.size(), 1U);
        const BadCells& bad = assembled.report.bad_cells[0];
        EXPECT_EQ(bad.reason, GetParam().reason);
        EXPECT_EQ(bad.count, 1U);
        EXPECT_EQ(bad.first_ids, std::vector<Index>{cell});
        EXPECT_EQ(assembled.mesh.cell_types.size(), 3U);
        EXPECT_THAT(assembled.original_cell, testing::Not(testing::Contains(cell)));
        EXPECT_EQ(std::count(assembled.mesh.neighbour.begin(), assembled.mesh.neighbour.end(), none),
                  cell == 0 ? 14 : 16);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, BadCell,
    testing::Values(BadCase{"a_face_missing", [](auto& loops) { loops.pop_back(); }, Reason::open},
                    BadCase{"a_face_twice", [](auto& loops) { loops.push_back(loops[0]); }, Reason::open},
                    BadCase{"a_face_short_of_a_corner", [](auto& loops) { loops[2].pop_back(); }, Reason::open},
                    BadCase{"no_faces", [](auto& loops) { loops.clear(); }, Reason::too_few_faces},
                    BadCase{"three_faces", [](auto& loops) { loops.resize(3); }, Reason::too_few_faces},
                    BadCase{"vertex_beyond_the_last", [](auto& loops) { loops[5][3] = 20; },
                            Reason::index_out_of_range},
                    BadCase{"vertex_none", [](auto& loops) { loops[0][0] = none; }, Reason::index_out_of_range},
                    BadCase{"one_sided", [](auto& loops) { loops = one_sided; }, Reason::inconsistent_winding}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(BadCells, ANaNPositionTakesOutTheCellsThatUseIt) {
    Polyhedra row = cubes();
    row.positions[0] = nan; // a corner of cell 0 only
    const Assembled assembled = assemble(view(row));
    ASSERT_EQ(assembled.report.bad_cells.size(), 1U);
    EXPECT_EQ(assembled.report.bad_cells[0].first_ids, std::vector<Index>{0});
    EXPECT_EQ(assembled.mesh.cell_types.size(), 3U);
    for (float x : assembled.mesh.positions) EXPECT_TRUE(std::isfinite(x));
}

TEST(BadCells, EachReasonHasItsEntryAndAtMostTenIds) {
    const Polyhedra row = hexahedra({{40, 1, 1}});
    Polyhedra mesh = keep_cells(row, [](Id) { return false; });
    for (Id c = 0; c < row.cell_count(); ++c) {
        std::vector<Loop> loops = row.loops(c);
        if (c % 2 == 0) loops.pop_back();
        if (c == 5) loops[0][0] = 4000;
        mesh.add_cell(polyhedron, loops);
    }
    const Assembled assembled = assemble(view(mesh));
    ASSERT_EQ(assembled.report.bad_cells.size(), 2U);
    for (const BadCells& bad : assembled.report.bad_cells) {
        if (bad.reason == Reason::open) {
            EXPECT_EQ(bad.count, 20U);
            EXPECT_EQ(bad.first_ids, (std::vector<Index>{0, 2, 4, 6, 8, 10, 12, 14, 16, 18}));
        } else {
            EXPECT_EQ(bad.reason, Reason::index_out_of_range);
            EXPECT_EQ(bad.first_ids, std::vector<Index>{5});
        }
    }
}

// assemble() ignores faces without vertices.
TEST(BadCells, AFaceWithoutCornersIsNothing) {
    Polyhedra row = keep_cells(cubes(), [](Id) { return false; });
    for (Id cell = 0; cell < 4; ++cell) {
        std::vector<Loop> loops = cubes().loops(cell);
        loops.emplace_back();
        row.add_cell(polyhedron, loops);
    }
    const Assembled assembled = assemble(view(row));
    EXPECT_TRUE(assembled.report.bad_cells.empty());
    EXPECT_EQ(Topology(assembled.mesh.view()).counts().half_edges, 4U * 24);
}

// Three cubes share the face between the first two, so that face is not matched.
TEST(BadCells, AFaceThatThreeCellsClaimStaysUnmatched) {
    Polyhedra mesh = hexahedra({{2, 1, 1}});
    std::vector<Loop> third = mesh.loops(0);
    std::map<Id, Id> moved; // the third cell's own vertices, except on the shared face
    const Loop shared = third[1];
    for (Loop& loop : third) {
        for (Id& v : loop) {
            if (std::find(shared.begin(), shared.end(), v) != shared.end()) continue;
            const Point p = mesh.position(v);
            if (!moved.contains(v)) moved[v] = mesh.add_vertex({p[0] - 0.5, p[1] + 0.25, p[2]});
            v = moved[v];
        }
    }
    mesh.add_cell(hexahedron, third);
    const Assembled assembled = assemble(view(mesh));
    EXPECT_TRUE(assembled.report.bad_cells.empty());
    EXPECT_EQ(assembled.report.internal_boundaries, 1U);
    EXPECT_EQ(assembled.mesh.owner.size(), 18U);
    for (Index neighbour : assembled.mesh.neighbour) EXPECT_EQ(neighbour, none);
}

// A cell whose type does not match its faces becomes a polyhedron.
TEST(BadCells, ATypeThatDoesNotFitTheFacesBecomesAPolyhedron) {
    Polyhedra mesh = hexagonal_prisms(1, 1, 1);
    mesh.cell_types[0] = hexahedron;
    EXPECT_EQ(assemble(view(mesh)).mesh.cell_types.at(0), polyhedron);
}

struct BadArrays {
    const char* name;
    std::function<void(Polyhedra&)> change;
    const char* error;
};

std::ostream& operator<<(std::ostream& out, const BadArrays& bad) { return out << bad.name; }

class BadSizes : public testing::TestWithParam<BadArrays> {};

TEST_P(BadSizes, AreRefusedByName) {
    Polyhedra mesh = cubes();
    GetParam().change(mesh);
    try {
        (void)assemble(view(mesh));
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr(GetParam().error));
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, BadSizes,
    testing::Values(BadArrays{"positions", [](Polyhedra& m) { m.positions.pop_back(); }, "positions"},
                    BadArrays{"types", [](Polyhedra& m) { m.cell_types.pop_back(); }, "cell_offset"},
                    BadArrays{"unknown_type", [](Polyhedra& m) { m.cell_types[1] = 11; }, "type 11"},
                    BadArrays{"no_cell_offset", [](Polyhedra& m) { m.cell_offset.clear(); }, "cell_offset"},
                    BadArrays{"cell_offset_end", [](Polyhedra& m) { ++m.cell_offset.back(); }, "cell_offset"},
                    BadArrays{"cell_offset_falls", [](Polyhedra& m) { m.cell_offset[1] = 20; }, "cell_offset"},
                    BadArrays{"cell_offset_start", [](Polyhedra& m) { m.cell_offset[0] = 1; }, "cell_offset"},
                    BadArrays{"no_face_offset", [](Polyhedra& m) { m.face_offset.clear(); }, "offset"},
                    BadArrays{"face_offset_end", [](Polyhedra& m) { m.face_vertex.pop_back(); }, "face_offset"},
                    BadArrays{"face_offset_falls", [](Polyhedra& m) { m.face_offset[3] = 50; }, "face_offset"}),
    [](const auto& test) { return std::string(test.param.name); });

class StandardCorners : public testing::TestWithParam<std::tuple<CellType, int, int>> {};

TEST_P(StandardCorners, TakesItsNumberOfCornersOnly) {
    const auto [type, corners, faces] = GetParam();
    std::vector<std::uint64_t> face_offset{0};
    std::vector<Index> face_vertex;
    std::vector<Index> ids;
    for (int i = 0; i < corners; ++i) ids.push_back(static_cast<Index>(100 + i));
    append_standard_faces(type, ids, face_offset, face_vertex);
    EXPECT_EQ(face_offset.size(), static_cast<std::size_t>(faces) + 1);
    EXPECT_EQ(face_offset.back(), face_vertex.size());
    EXPECT_THAT(face_vertex,
                testing::Each(testing::AllOf(testing::Ge(100U), testing::Lt(100U + static_cast<Index>(corners)))));
    ids.push_back(7);
    EXPECT_THROW(append_standard_faces(type, ids, face_offset, face_vertex), Error);
    EXPECT_EQ(face_offset.size(), static_cast<std::size_t>(faces) + 1); // a refused call appends nothing
}

INSTANTIATE_TEST_SUITE_P(All, StandardCorners,
                         testing::Values(std::tuple{CellType::tetrahedron, 4, 4},
                                         std::tuple{CellType::hexahedron, 8, 6}, std::tuple{CellType::wedge, 6, 5},
                                         std::tuple{CellType::pyramid, 5, 5}));

TEST(StandardCell, APolyhedronIsNotStandard) {
    std::vector<std::uint64_t> face_offset{0};
    std::vector<Index> face_vertex;
    EXPECT_THROW(append_standard_faces(CellType::polyhedron, std::vector<Index>{0, 1, 2, 3}, face_offset, face_vertex),
                 Error);
}

// Positions in VTK's vertex order. Outward faces give a positive volume.
TEST(StandardCell, FacesAreWoundOutwards) {
    struct Shape {
        CellType type;
        std::vector<Point> corners;
    };
    const std::vector<Shape> shapes{
        {CellType::tetrahedron, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        {CellType::hexahedron,
         {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}},
        // In a VTK wedge, the normal of the first triangle points away from the second triangle.
        {CellType::wedge, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}}},
        {CellType::pyramid, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}},
    };
    for (const Shape& shape : shapes) {
        Polyhedra mesh;
        std::vector<Index> ids;
        for (const Point& p : shape.corners) ids.push_back(mesh.add_vertex(p));
        append_standard_faces(shape.type, ids, mesh.face_offset, mesh.face_vertex);
        mesh.cell_offset.push_back(mesh.face_count());
        mesh.cell_types.push_back(static_cast<std::uint8_t>(shape.type));
        const Assembled assembled = assemble(view(mesh));
        EXPECT_TRUE(assembled.report.bad_cells.empty());
        EXPECT_EQ(assembled.report.reversed_cells, 0U) << static_cast<int>(shape.type);
        EXPECT_EQ(assembled.report.reversed_faces, 0U) << static_cast<int>(shape.type);
        EXPECT_EQ(assembled.mesh.cell_types, mesh.cell_types);
    }
}

} // namespace
} // namespace ciel::test
