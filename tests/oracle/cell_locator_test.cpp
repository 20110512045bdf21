#include "ciel/cell_locator.hpp"

#include "ciel/assemble.hpp"
#include "mesh/cell_faces.hpp"
#include "support/fields.hpp"
#include "support/kept.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <gtest/gtest.h>
#include <random>

namespace ciel {
namespace {

CellLocator locator_of(const Topology& topology, const FaceMeshView& mesh) {
    return {topology, mesh, std::make_shared<const BlockBoxes>(block_boxes(topology, mesh.positions))};
}

class CellLocators : public testing::TestWithParam<test::NamedMesh> {};

Vec3d vertex_at(const FaceMeshView& mesh, Index vertex) {
    Vec3d at = mesh.origin;
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] += mesh.positions[std::size_t{3} * vertex + axis];
    return at;
}

Vec3d middle_of(const FaceMeshView& mesh, Index face) {
    const auto loop = mesh.loop(face);
    Vec3d middle{};
    for (const Index vertex : loop)
        for (std::size_t axis = 0; axis < 3; ++axis)
            middle[axis] += vertex_at(mesh, vertex)[axis] / static_cast<double>(loop.size());
    return middle;
}

TEST_P(CellLocators, WeightsAreExactForALinearField) {
    const test::LinearField field{{1, -2, 0.5}, 3};
    const Assembled assembled = assemble(test::view(GetParam().make()));
    const FaceMeshView mesh = test::kept(assembled.mesh.view());
    const Topology topology(mesh, {7});
    const CellLocator locator = locator_of(topology, mesh);
    if (mesh.cell_count() == 0) {
        EXPECT_EQ(locator.cell_at({0, 0, 0}), none);
        return;
    }
    std::mt19937 random(5);
    int found = 0;
    for (int i = 0; i < 40; ++i) {
        const Vec3d at = middle_of(mesh, random() % mesh.face_count());
        const Index cell = locator.cell_at(at);
        if (cell == none) continue;
        ++found;
        double value = 0, sum = 0;
        for (const auto& [vertex, share] : locator.weights_in(cell, at)) {
            value += share * field.at(vertex_at(mesh, vertex));
            sum += share;
        }
        EXPECT_NEAR(sum, 1, 1e-9);
        EXPECT_NEAR(value, field.at(at), 1e-4);
    }
    EXPECT_GE(found, GetParam().planar_faces ? 40 : 30);
}

// At a vertex, the interpolated value must have the bits of the stored one.
TEST_P(CellLocators, AVertexHasItsOwnWeightAlone) {
    const Assembled assembled = assemble(test::view(GetParam().make()));
    const FaceMeshView mesh = test::kept(assembled.mesh.view());
    const CellLocator locator = locator_of(Topology(mesh), mesh);
    for (Index face = 0; face < mesh.face_count(); ++face)
        for (const Index corner : mesh.loop(face)) {
            const Vec3d at = vertex_at(mesh, corner);
            const VertexWeights weights = locator.weights_in(mesh.owner[face], at);
            ASSERT_EQ(weights.size(), 1U);
            ASSERT_EQ(weights[0].second, 1);
            ASSERT_EQ(vertex_at(mesh, weights[0].first), at); // another vertex only where two are at one place
        }
}

// The cell found at a point must not depend on the size of the blocks or on the face loops that they store.
TEST_P(CellLocators, FindTheSameCellWithBlocksOfAnySize) {
    const Assembled assembled = assemble(test::view(GetParam().make()));
    const FaceMeshView mesh = test::kept(assembled.mesh.view());
    if (mesh.cell_count() == 0) return;
    const Topology one(mesh), many(mesh, {5});
    const CellLocator of_one = locator_of(one, mesh), of_many = locator_of(many, mesh);
    std::mt19937 random(6);
    int inside = 0;
    for (int i = 0; i < 60; ++i) {
        Vec3d at{};
        for (const double share : {0.1173, 0.2391, 0.3118, 0.3318}) { // avoids points on faces: each has two cells
            const Vec3d vertex = vertex_at(mesh, random() % mesh.vertex_count());
            for (std::size_t axis = 0; axis < 3; ++axis) at[axis] += share * vertex[axis];
        }
        const Index cell = of_one.cell_at(at);
        ASSERT_EQ(of_many.cell_at(at), cell);
        if (cell == none) continue;
        ++inside;
        EXPECT_EQ(of_many.nearest_vertex(cell, at), of_one.nearest_vertex(cell, at));
        EXPECT_EQ(of_many.weights_in(cell, at).size(), of_one.weights_in(cell, at).size());
    }
    EXPECT_GT(inside, 0);
    EXPECT_THROW((void)of_many.nearest_vertex(static_cast<Index>(mesh.cell_count()), {}), Error);
    if (many.block_count() == 1) return;
    const auto of_other = std::make_shared<const BlockBoxes>(block_boxes(many, mesh.positions));
    EXPECT_THROW(CellLocator(one, mesh, of_other), Error);
}

INSTANTIATE_TEST_SUITE_P(All, CellLocators, testing::ValuesIn(test::all_meshes()),
                         [](const auto& each) { return each.param.name; });

TEST(CellLocator, KnowsCellsTheirNearestVertexAndTheOutside) {
    const Assembled assembled = assemble(test::view(test::tetrahedra({{4, 4, 4}})));
    const FaceMeshView mesh = test::kept(assembled.mesh.view());
    const Topology topology(mesh, {50});
    const CellLocator locator = locator_of(topology, mesh);
    const detail::CellFaces faces = detail::cell_faces(mesh);
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        Vec3d middle{};
        Index last = none;
        faces.for_faces(cell, [&](Index face) {
            for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] += middle_of(mesh, face)[axis] / 4;
            last = face;
        });
        ASSERT_EQ(locator.cell_at(middle), cell);
        const Index corner = mesh.loop(last)[0];
        Vec3d near{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            near[axis] = 0.9 * vertex_at(mesh, corner)[axis] + 0.1 * middle[axis];
        ASSERT_EQ(locator.cell_at(near), cell);
        ASSERT_EQ(locator.nearest_vertex(cell, near), corner);
    }
    for (const Vec3d& outside : {Vec3d{-1e3, 0, 0}, Vec3d{1e30, 1e30, 1e30}}) EXPECT_EQ(locator.cell_at(outside), none);
}

} // namespace
} // namespace ciel
