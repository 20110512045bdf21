// assemble() keeps the cells and faces of its input, in any order and winding. Results are compared in the input's ids.
#include "ciel/assemble.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace ciel::test {
namespace {

using CellFaces = std::vector<std::multiset<Loop>>; // outward loops of each input cell

CellFaces faces_of(const Polyhedra& mesh) {
    CellFaces result(mesh.cell_count());
    for (Id c = 0; c < mesh.cell_count(); ++c) {
        for (const Loop& loop : mesh.loops(c)) result[c].insert(canonical(loop));
    }
    return result;
}

CellFaces faces_of(const Assembled& assembled, Id input_cells) {
    CellFaces result(input_cells);
    const FaceMeshView mesh = assembled.mesh.view();
    for (Index f = 0; f < mesh.face_count(); ++f) {
        Loop loop;
        for (Index v : mesh.loop(f)) loop.push_back(assembled.original_vertex[v]);
        result[assembled.original_cell[mesh.owner[f]]].insert(canonical(loop));
        std::reverse(loop.begin(), loop.end());
        if (mesh.neighbour[f] != none) result[assembled.original_cell[mesh.neighbour[f]]].insert(canonical(loop));
    }
    return result;
}

// When two cells list a face differently (a collapsed quadrilateral beside a triangle), the mesh stores the owner's
// loop. Repeated vertices are therefore removed before comparing.
CellFaces comparable(const CellFaces& cells) {
    CellFaces result(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
        for (const Loop& loop : cells[c]) result[c].insert(canonical(without_repeats(loop)));
    }
    return result;
}

class Assemble : public testing::TestWithParam<NamedMesh> {
protected:
    Polyhedra input = GetParam().make();

    void expect_same_cells(const Assembled& assembled) const {
        ASSERT_TRUE(assembled.report.bad_cells.empty());
        EXPECT_EQ(comparable(faces_of(assembled, input.cell_count())), comparable(faces_of(input)));
    }
};

TEST_P(Assemble, KeepsEveryCellAndItsOutwardFaces) {
    const Assembled assembled = assemble(view(input));
    expect_same_cells(assembled);
    EXPECT_EQ(assembled.report.reversed_cells, 0U);
    EXPECT_EQ(assembled.report.reversed_faces, 0U);
}

TEST_P(Assemble, KeepsTheContractOfFaceMeshView) {
    const Assembled assembled = assemble(view(input));
    const FaceMeshView mesh = assembled.mesh.view();
    EXPECT_EQ(mesh.origin, input.origin);
    ASSERT_EQ(mesh.face_offset.size(), std::size_t{mesh.face_count()} + 1);
    ASSERT_EQ(mesh.neighbour.size(), mesh.owner.size());
    EXPECT_TRUE(std::is_sorted(mesh.owner.begin(), mesh.owner.end()));
    for (Index f = 0; f < mesh.face_count(); ++f) {
        ASSERT_LT(mesh.owner[f], mesh.cell_count());
        ASSERT_TRUE(mesh.neighbour[f] == none || mesh.neighbour[f] < mesh.cell_count());
        ASSERT_LT(mesh.owner[f], mesh.neighbour[f]);
        for (Index v : mesh.loop(f)) ASSERT_LT(v, mesh.vertex_count());
    }
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        EXPECT_EQ(mesh.cell_types[c], input.cell_types[assembled.original_cell[c]]);
    }
}

TEST_P(Assemble, CarriesVerticesAndTheLoopsOfOwners) {
    const Assembled assembled = assemble(view(input));
    const FaceMeshView mesh = assembled.mesh.view();
    std::set<Id> used(input.face_vertex.begin(), input.face_vertex.end());
    EXPECT_EQ(std::set<Id>(assembled.original_vertex.begin(), assembled.original_vertex.end()), used);
    ASSERT_EQ(assembled.original_vertex.size(), mesh.vertex_count());
    EXPECT_EQ(used.size(), mesh.vertex_count());
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        for (std::size_t d = 0; d < 3; ++d) {
            EXPECT_EQ(mesh.positions[3 * v + d], input.positions[3 * assembled.original_vertex[v] + d]);
        }
    }
    const CellFaces listed = faces_of(input);
    for (Index f = 0; f < mesh.face_count(); ++f) {
        Loop loop;
        for (Index v : mesh.loop(f)) loop.push_back(assembled.original_vertex[v]);
        EXPECT_TRUE(listed[assembled.original_cell[mesh.owner[f]]].contains(canonical(loop))) << "face " << f;
    }
}

// The same mesh, but with the corners of the standard cells whose faces are in the order of append_standard_faces.
struct ByCorners {
    Polyhedra listed; // the other cells
    std::vector<std::uint64_t> corner_offset{0};
    std::vector<Index> corner;

    explicit ByCorners(const Polyhedra& mesh) : listed(mesh) {
        listed.cell_offset.assign(1, 0);
        listed.face_offset.assign(1, 0);
        listed.face_vertex.clear();
        for (Id cell = 0; cell < mesh.cell_count(); ++cell) {
            const std::vector<Index> corners = corners_of(mesh, cell);
            corner.insert(corner.end(), corners.begin(), corners.end());
            corner_offset.push_back(corner.size());
            if (corners.empty())
                for (const Loop& loop : mesh.loops(cell)) {
                    listed.face_vertex.insert(listed.face_vertex.end(), loop.begin(), loop.end());
                    listed.face_offset.push_back(listed.face_vertex.size());
                }
            listed.cell_offset.push_back(listed.face_offset.size() - 1);
        }
    }
    [[nodiscard]] PolyhedraView view() const {
        PolyhedraView out = test::view(listed);
        out.corner_offset = corner_offset;
        out.corner = corner;
        return out;
    }

    // Returns no corners if the faces do not have the order of append_standard_faces.
    static std::vector<Index> corners_of(const Polyhedra& mesh, Id cell) {
        const std::map<std::uint8_t, std::size_t> counts{{tetrahedron, 4}, {hexahedron, 8}, {wedge, 6}, {pyramid, 5}};
        const auto count = counts.find(mesh.cell_types[cell]);
        if (count == counts.end()) return {};
        std::vector<Index> places(count->second), corners(count->second, none), places_of_faces, vertices;
        std::iota(places.begin(), places.end(), 0U);
        std::vector<std::uint64_t> offset{0}, wanted{0};
        append_standard_faces(static_cast<CellType>(count->first), places, wanted, places_of_faces);
        for (const Loop& loop : mesh.loops(cell)) {
            vertices.insert(vertices.end(), loop.begin(), loop.end());
            offset.push_back(vertices.size());
        }
        if (offset != wanted) return {};
        for (std::size_t i = 0; i < vertices.size(); ++i) corners[places_of_faces[i]] = vertices[i];
        for (std::size_t i = 0; i < vertices.size(); ++i)
            if (corners[places_of_faces[i]] != vertices[i]) return {};
        return corners;
    }
};

TEST_P(Assemble, CornersGiveTheSameMeshAsFaces) {
    const ByCorners by_corners(input);
    const Assembled expected = assemble(view(input)), found = assemble(by_corners.view());
    EXPECT_EQ(found.original_vertex, expected.original_vertex);
    EXPECT_EQ(found.original_cell, expected.original_cell);
    EXPECT_EQ(found.mesh.positions, expected.mesh.positions);
    EXPECT_EQ(found.mesh.cell_types, expected.mesh.cell_types);
    EXPECT_EQ(found.mesh.face_offset, expected.mesh.face_offset);
    EXPECT_EQ(found.mesh.face_vertex, expected.mesh.face_vertex);
    EXPECT_EQ(found.mesh.owner, expected.mesh.owner);
    EXPECT_EQ(found.mesh.neighbour, expected.mesh.neighbour);
}

TEST(AssembleCorners, WrongCornersAreRefusedOrLeftOut) {
    const Polyhedra input = hexahedra({{3, 1, 1}});
    ByCorners mesh(input);
    ASSERT_EQ(mesh.corner.size(), 24U); // the test's cells list their faces in this order
    mesh.corner[9] = 1000;
    const Assembled found = assemble(mesh.view());
    ASSERT_EQ(found.report.bad_cells.size(), 1U);
    EXPECT_EQ(found.report.bad_cells[0].reason, BadCells::Reason::index_out_of_range);
    EXPECT_EQ(found.report.bad_cells[0].first_ids, std::vector<Index>{1});
    EXPECT_EQ(found.mesh.cell_types.size(), 2U);

    mesh.corner_offset[1] = 7;
    EXPECT_THROW((void)assemble(mesh.view()), Error);
    mesh.corner_offset = {0, 8, 24};
    EXPECT_THROW((void)assemble(mesh.view()), Error);
    const std::vector<std::uint64_t> offset{0, 8, 16, 24};
    PolyhedraView both = view(input);
    both.corner_offset = offset;
    both.corner = mesh.corner;
    EXPECT_THROW((void)assemble(both), Error); // the cells list their faces, too
}

TEST_P(Assemble, FacesMatchWhereTwoCellsClaimThem) {
    std::map<std::set<Id>, std::vector<Id>> claims;
    for (Id c = 0; c < input.cell_count(); ++c) {
        for (const Loop& loop : input.loops(c)) {
            const std::set<Id> key(loop.begin(), loop.end());
            if (key.size() >= 3) claims[key].push_back(c);
        }
    }
    const Assembled assembled = assemble(view(input));
    const FaceMeshView mesh = assembled.mesh.view();
    std::map<std::set<Id>, std::vector<Id>> found;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        std::set<Id> key;
        for (Index v : mesh.loop(f)) key.insert(assembled.original_vertex[v]);
        if (key.size() < 3) continue;
        found[key].push_back(assembled.original_cell[mesh.owner[f]]);
        if (mesh.neighbour[f] != none) found[key].push_back(assembled.original_cell[mesh.neighbour[f]]);
        EXPECT_EQ(mesh.neighbour[f] == none, claims[key].size() != 2);
    }
    for (auto& [key, cells] : found) std::sort(cells.begin(), cells.end());
    EXPECT_EQ(found, claims);
}

TEST_P(Assemble, AnyOrderGivesTheSameMesh) {
    for (std::uint64_t seed : {61, 62, 63}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Shuffled other = shuffled(input, seed);
        const Assembled assembled = assemble(view(other.mesh));
        ASSERT_TRUE(assembled.report.bad_cells.empty());
        const CellFaces faces = comparable(faces_of(assembled, input.cell_count()));
        const CellFaces expected = comparable(faces_of(input));
        for (Id c = 0; c < input.cell_count(); ++c) ASSERT_EQ(faces[c], expected[other.cell_of[c]]) << "cell " << c;
    }
}

TEST_P(Assemble, TurnedFacesAreTurnedBack) {
    for (std::uint64_t seed : {71, 72, 73}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Assembled assembled = assemble(view(with_turned_faces(input, 0.5, seed)));
        expect_same_cells(assembled);
        EXPECT_EQ(assembled.report.reversed_faces > 0, input.cell_count() > 0);
    }
}

TEST_P(Assemble, TurnedCellsAreTurnedBackAndCounted) {
    for (std::uint64_t seed : {81, 82, 83}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Polyhedra turned = with_turned_cells(input, 0.5, seed);
        std::uint64_t expected = 0;
        for (Id c = 0; c < input.cell_count(); ++c) expected += turned.loops(c) != input.loops(c) ? 1 : 0;
        const Assembled assembled = assemble(view(turned));
        expect_same_cells(assembled);
        EXPECT_EQ(assembled.report.reversed_cells, expected);
        EXPECT_EQ(assembled.report.reversed_faces, 0U);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Assemble, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

TEST(AssembleOneFace, OneTurnedFaceIsCounted) {
    for (std::uint64_t face = 0; face < 6; ++face) {
        Polyhedra cube = hexahedra({{1, 1, 1}});
        std::reverse(cube.face_vertex.begin() + static_cast<std::ptrdiff_t>(4 * face),
                     cube.face_vertex.begin() + static_cast<std::ptrdiff_t>(4 * face + 4));
        const Assembled assembled = assemble(view(cube));
        EXPECT_EQ(assembled.report.reversed_faces, 1U) << face;
        EXPECT_EQ(assembled.report.reversed_cells, 0U) << face;
    }
}

// The jitter inverts some cells. assemble() keeps their winding consistent with the neighbors and reports them.
TEST(AssembleFolded, CellsStayWoundLikeTheirNeighboursAndAreNamed) {
    const Polyhedra folded = hexahedra({{9, 9, 9}, 0.9, 91});
    std::vector<Id> inverted;
    for (Id c = 0; c < folded.cell_count(); ++c) {
        if (signed_volume(folded, c) < 0) inverted.push_back(c);
    }
    ASSERT_GT(inverted.size(), 10U);
    const Assembled assembled = assemble(view(folded));
    EXPECT_TRUE(assembled.report.bad_cells.empty());
    EXPECT_EQ(faces_of(assembled, folded.cell_count()), faces_of(folded));
    EXPECT_EQ(assembled.report.inverted_cells, inverted.size());
    inverted.resize(10);
    EXPECT_EQ(assembled.report.first_inverted, inverted);
}

} // namespace
} // namespace ciel::test
