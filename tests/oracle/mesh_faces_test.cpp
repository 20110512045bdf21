#include "ciel/mesh_faces.hpp"

#include "ciel/assemble.hpp"
#include "ciel/numbered_faces.hpp"
#include "mesh/cell_faces.hpp"
#include "support/boundary.hpp"
#include "support/kept.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace ciel {
namespace {

using Sides = std::set<std::pair<Index, Index>>; // face, cell

Sides sides(const std::vector<CellFace>& faces) {
    Sides all;
    for (const auto& [face, cell] : faces) all.emplace(face, cell);
    EXPECT_EQ(all.size(), faces.size()) << "a face is listed twice";
    return all;
}

// A box of 3 x 3 x 3 unit cubes, with half of its cells kept at random.
class MeshFaces : public testing::Test {
protected:
    MeshFaces() {
        std::mt19937 random(7);
        for (auto& flag : kept) flag = random() % 2 != 0 ? 1 : 0;
    }

    Assembled assembled = assemble(test::view(test::hexahedra({{3, 3, 3}})));
    FaceMeshView mesh = assembled.mesh.view();
    std::vector<std::uint8_t> kept = std::vector<std::uint8_t>(mesh.cell_count());
};

TEST_F(MeshFaces, TheBoundaryHasNineFacesASide) {
    const Sides boundary = sides(boundary_faces(mesh));
    EXPECT_EQ(boundary.size(), 54U);
    for (const auto& [face, cell] : boundary) EXPECT_EQ(mesh.neighbour[face], none);
}

TEST_F(MeshFaces, FacesByIdAreSortedOnceAndOfKeptOwners) {
    const std::vector<Index> ids{20, 3, 3, 50, 20, 0};
    std::vector<Index> all;
    for (const CellFace& each : faces_by_id(mesh, ids)) {
        all.push_back(each.face);
        EXPECT_EQ(each.cell, mesh.owner[each.face]);
    }
    EXPECT_EQ(all, (std::vector<Index>{0, 3, 20, 50}));
    Sides expected;
    for (const Index face : ids)
        if (kept[mesh.owner[face]] != 0) expected.emplace(face, mesh.owner[face]);
    EXPECT_EQ(sides(faces_by_id(mesh, ids, kept)), expected);
}

TEST_F(MeshFaces, FacesAtALevelAreThoseOfOneSide) {
    std::vector<float> heights;
    for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex)
        heights.push_back(mesh.positions[std::size_t{3} * vertex + 2] + static_cast<float>(mesh.origin[2]));
    const Topology topology(mesh);
    const Field field(topology, heights, test::kept_by_test);
    EXPECT_EQ(boundary_faces_at(mesh, field, 3, 1e-6).size(), 9U);
    EXPECT_EQ(boundary_faces_at(mesh, field, 1, 1e-6).size(), 0U) << "a level between layers of cells";
    EXPECT_EQ(boundary_faces_at(mesh, field, 3.5, 0.5 + 1e-6).size(), 9U);
}

TEST_F(MeshFaces, AFaceIsFoundByThreeOfItsVertices) {
    std::vector<Index> ids(mesh.face_count());
    for (Index face = 0; face < mesh.face_count(); ++face) ids[face] = face;
    for (const Index face : ids) {
        const auto loop = mesh.loop(face);
        const std::array<Index, 3> three{loop[3], loop[0], loop[2]};
        ASSERT_EQ(face_with_vertices(mesh, ids, three), face);
    }
    EXPECT_EQ(face_with_vertices(mesh, std::span(ids).first(1), std::array<Index, 1>{mesh.loop(40)[0]}), none);
    EXPECT_EQ(face_with_vertices(mesh, {}, std::array<Index, 1>{0}), none);
}

TEST(VerticesOfCells, AreTheirCorners) {
    for (const test::Polyhedra& input : {test::hexahedra({{3, 3, 3}}), test::zoo({{3, 3, 3}})})
        for (const Index cells_per_block : {1U, 5U, 4096U}) {
            const Assembled assembled = assemble(test::view(input));
            const FaceMeshView mesh = assembled.mesh.view();
            const Topology topology(mesh, {cells_per_block});
            const detail::CellFaces faces = detail::cell_faces(mesh);
            for (const Index one_in : {1U, 2U, 9U}) {
                std::vector<std::uint8_t> kept(mesh.cell_count());
                std::set<Index> expected;
                for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
                    kept[cell] = cell % one_in == 0 ? 1 : 0;
                    faces.for_faces(cell, [&](Index face) {
                        for (const Index vertex : mesh.loop(face))
                            if (kept[cell] != 0) expected.insert(vertex);
                    });
                }
                const Surface points = vertices_of_cells(topology, mesh, kept);
                ASSERT_EQ(points.points.size(), expected.size());
                ASSERT_EQ(points.positions.size(), expected.size());
                auto next = expected.begin();
                for (std::size_t i = 0; i < points.points.size(); ++i, ++next) {
                    EXPECT_EQ(points.points[i].a, *next);
                    EXPECT_EQ(points.positions[i][0], static_cast<float>(mesh.positions[std::size_t{3} * *next]));
                }
                if (one_in == 1) {
                    EXPECT_EQ(vertices_of_cells(topology, mesh, {}).positions, points.positions);
                }
            }
            EXPECT_THROW((void)vertices_of_cells(topology, mesh, std::vector<std::uint8_t>(3)), Error);
        }
}

TEST(SameCells, AreFoundInAnyBlocksAndFromAnyCorner) {
    for (const test::NamedMesh& named : test::all_meshes()) {
        FaceMesh mesh = assemble(test::view(named.make())).mesh;
        if (mesh.cell_types.empty()) continue;
        const Topology topology(mesh.view(), {5});
        EXPECT_TRUE(same_cells(topology, Topology(mesh.view()))) << named.name;
        const auto first = mesh.face_vertex.begin();
        std::rotate(first, first + 1, first + static_cast<int>(mesh.face_offset[1]));
        EXPECT_TRUE(same_cells(topology, Topology(mesh.view()))) << named.name;
        for (Index& vertex : mesh.face_vertex) // exchanges the ids of two vertices
            if (vertex <= 1) vertex = 1 - vertex;
        EXPECT_FALSE(same_cells(topology, Topology(mesh.view()))) << named.name;
    }
}

// Also for meshes with collapsed faces, which the blocks do not contain.
TEST(AllFaces, AreThoseThatTheBlocksWereMadeOf) {
    for (const test::NamedMesh& named : test::all_meshes())
        for (const Index cells_per_block : {1U, 5U, 4096U}) {
            const Assembled assembled = assemble(test::view(named.make()));
            const FaceMeshView mesh = assembled.mesh.view();
            const Topology topology(mesh, {cells_per_block});
            const test::Boundary boundary(mesh);
            const FaceLists faces = all_faces(topology, boundary.faces());
            const FaceMeshView made = with_faces(test::kept(mesh), std::make_shared<const FaceLists>(faces));
            EXPECT_EQ(faces.owner, assembled.mesh.owner) << named.name;
            EXPECT_TRUE(same_cells(topology, Topology(made))) << named.name;
            const FaceLists again = numbered_faces(made, {}), wanted = numbered_faces(mesh, {});
            EXPECT_EQ(again.face_offset, wanted.face_offset) << named.name;
            EXPECT_EQ(again.face_vertex, wanted.face_vertex) << named.name;
            for (Index face = 0; face < made.face_count(); ++face)
                ASSERT_LT(made.owner[face], made.neighbour[face]) << named.name;
        }
}

TEST(NumberedFaces, AreTheBoundaryAndThenOthers) {
    const Assembled assembled = assemble(test::view(test::zoo({{3, 3, 3}})));
    const FaceMeshView mesh = assembled.mesh.view();
    std::vector<Index> on, inside;
    for (Index face = 0; face < mesh.face_count(); ++face) (mesh.neighbour[face] == none ? on : inside).push_back(face);
    const std::vector<Index> some{inside[4], inside[7]};
    const FaceLists faces = numbered_faces(mesh, some);
    std::vector<Index> ids = on;
    ids.insert(ids.end(), some.begin(), some.end());
    ASSERT_EQ(faces.owner.size(), ids.size());
    const FaceMeshView made = with_faces(test::kept(mesh), std::make_shared<const FaceLists>(faces));
    for (Index number = 0; number < ids.size(); ++number) {
        EXPECT_TRUE(std::ranges::equal(made.loop(number), mesh.loop(ids[number])));
        EXPECT_EQ(made.owner[number], mesh.owner[ids[number]]);
        EXPECT_EQ(made.neighbour[number], mesh.neighbour[ids[number]]);
    }
    const std::vector<Index> asked{on[5], inside[4], on[0], on[5]};
    EXPECT_EQ(boundary_numbers(mesh, asked), (std::vector<Index>{5, none, 0, 5}));
}

TEST(SameCells, AreAsManyAndCloseTheSameFaces) {
    const FaceMesh row = assemble(test::view(test::hexahedra({{4, 1, 1}}))).mesh,
                   longer = assemble(test::view(test::hexahedra({{5, 1, 1}}))).mesh;
    EXPECT_FALSE(same_cells(Topology(row.view()), Topology(longer.view())));
    EXPECT_FALSE(same_cells(Topology(longer.view()), Topology(row.view())));
    FaceMesh inside_out = row;
    for (std::size_t face = 0; face + 1 < row.face_offset.size(); ++face)
        std::reverse(inside_out.face_vertex.begin() + static_cast<int>(row.face_offset[face]),
                     inside_out.face_vertex.begin() + static_cast<int>(row.face_offset[face + 1]));
    EXPECT_FALSE(same_cells(Topology(row.view()), Topology(inside_out.view())));
}

TEST(CornersOfCell, AreThoseOfItsFaces) {
    const Assembled assembled = assemble(test::view(test::zoo({{3, 3, 3}})));
    const FaceMeshView mesh = assembled.mesh.view();
    const detail::CellFaces faces = detail::cell_faces(mesh);
    const Topology topology(mesh, {5});
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        std::set<Index> expected;
        faces.for_faces(cell, [&](Index face) { expected.insert(mesh.loop(face).begin(), mesh.loop(face).end()); });
        EXPECT_TRUE(std::ranges::equal(corners_of_cell(topology, cell), expected)) << cell;
    }
    EXPECT_THROW((void)corners_of_cell(topology, mesh.cell_count()), Error);
}

TEST_F(MeshFaces, TheSizeOfASideIsItsBoxAndArea) {
    std::vector<Index> side;
    for (Index face = 0; face < mesh.face_count(); ++face) {
        bool is_side = mesh.neighbour[face] == none;
        for (const Index vertex : mesh.loop(face))
            is_side = is_side && std::abs(mesh.origin[0] + mesh.positions[std::size_t{3} * vertex] - 3) < 1e-6;
        if (is_side) side.push_back(face);
    }
    const FacesSize size = size_of_faces(mesh, side);
    EXPECT_NEAR(size.area, 9, 1e-5);
    EXPECT_EQ(size.low, (Vec3d{3, 0, 0}));
    EXPECT_EQ(size.high, (Vec3d{3, 3, 3}));
    EXPECT_EQ(size_of_faces(mesh, {}).area, 0);
}

} // namespace
} // namespace ciel
