// Who owns the arrays behind a mesh view and a field.
#include "ciel/cell_locator.hpp"
#include "ciel/extract.hpp"
#include "ciel/geometric_vertices.hpp"
#include "ciel/mesh.hpp"
#include "ciel/numbered_faces.hpp"
#include "unit/ciel/meshes.hpp"

#include <gmock/gmock.h>

namespace ciel::test {
namespace {

TEST(Ownership, WhatKeepsAViewRefusesOneWithoutAnOwner) {
    const FaceMesh mesh = hexahedra(2, 2, 2).assembled().mesh;
    const FaceMeshView borrowed = mesh.view(), owned = shared_view(mesh);
    const Topology topology(borrowed);
    const auto boxes = std::make_shared<const BlockBoxes>(block_boxes(topology, borrowed.positions));
    const auto faces = std::make_shared<const FaceLists>(numbered_faces(borrowed, {}));
    const std::vector<std::function<void(const FaceMeshView&)>> keep{
        [&](const FaceMeshView& view) { (void)Query(topology, view); },
        [&](const FaceMeshView& view) { Query(topology, owned).set_mesh(view); },
        [&](const FaceMeshView& view) { (void)CellLocator(topology, view, boxes); },
        [&](const FaceMeshView& view) {
            (void)Field::plane(topology, view, {}, {0, 0, 1}, *boxes);
        },
        [&](const FaceMeshView& view) { (void)GeometricVertices(view); },
        [&](const FaceMeshView& view) { (void)Mesh::from_stored(view); },
        [&](const FaceMeshView& view) { (void)with_faces(view, faces); },
    };
    for (std::size_t i = 0; i < keep.size(); ++i) {
        EXPECT_NO_THROW(keep[i](owned)) << i;
        EXPECT_THROW(keep[i](borrowed), Error) << i;
    }
}

TEST(Ownership, AFieldRefusesValuesWithoutAnOwner) {
    const FaceMesh mesh = hexahedra(2, 2, 2).assembled().mesh;
    const Topology topology(mesh.view());
    const std::vector<float> values(mesh.view().vertex_count());
    EXPECT_THROW(Field(topology, values, nullptr), Error);
}

TEST(Ownership, AFunctionTakesArraysWithoutAnOwner) {
    const FaceMesh mesh = hexahedra(2, 2, 2).assembled().mesh;
    const std::vector<float> values(mesh.view().vertex_count(), 1);
    EXPECT_THAT(vertex_gradients(mesh.view(), values), testing::Each(Vec3f{}));
}

// Under AddressSanitizer, a use after free is reported.
TEST(Ownership, ASharedViewOutlivesItsMesh) {
    std::unique_ptr<Query> query;
    std::unique_ptr<CellLocator> locator;
    {
        FaceMesh mesh = hexahedra(2, 2, 2).assembled().mesh;
        const Topology topology(mesh.view());
        const FaceMeshView view = shared_view(std::move(mesh));
        const BlockBoxes boxes = block_boxes(topology, view.positions);
        query = std::make_unique<Query>(topology, view);
        query->set_field(Field::plane(topology, view, {0, 0, 0.5}, {0, 0, 1}, boxes));
        locator = std::make_unique<CellLocator>(topology, view, std::make_shared<const BlockBoxes>(boxes));
    }
    Surface surface;
    query->extract(0, true, surface);
    EXPECT_EQ(surface.points.size(), 9U);
    EXPECT_NE(locator->cell_at({1.5, 0.5, 0.5}), none);
}

TEST(Ownership, PartsOfAMeshOutliveIt) {
    const FaceMesh stored = hexahedra(2, 2, 2).assembled().mesh;
    std::vector<double> raised(stored.positions.begin(), stored.positions.end());
    for (std::size_t i = 2; i < raised.size(); i += 3) raised[i] += 10;
    std::optional<FaceMeshView> before, after;
    {
        const Mesh mesh = Mesh::from_stored(shared_view(stored));
        before = mesh.stored();
        after = mesh.moved(ArrayView(raised, 3)).moved(ArrayView(raised, 3)).stored();
    }
    EXPECT_EQ(before->positions[2] + 10, after->positions[2]);
    EXPECT_EQ(before->owner[0], after->owner[0]);
}

} // namespace
} // namespace ciel::test
