// Boundaries and patches made from the numbered faces of a dataset have the same polygons as those made from the list
// of all faces.
#include "ciel/assemble.hpp"
#include "ciel/mesh_faces.hpp"
#include "geometry/cut.hpp"
#include "store/mesh_arrays.hpp"
#include "store/writer.hpp"
#include "support/folder.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <set>

namespace server::geometry {
using namespace ciel;
namespace {

// A dataset with groups of faces on the boundary, inside the mesh, and in both places.
class BoundarySurface : public testing::Test {
protected:
    BoundarySurface() {
        std::vector<Index> on, inside;
        for (Index face = 0; face < made.mesh.owner.size(); ++face)
            (made.mesh.neighbour[face] == none ? on : inside).push_back(face);
        store::Writer writer(folder / "zoo.ciel", {});
        using store::Group;
        named = {{Group::Of::faces, "wall", {on[2], on[9], on[40]}},
                 {Group::Of::faces, "lid", {on[3], on[9]}},
                 {Group::Of::faces, "baffle", {inside[7], inside[8]}},
                 {Group::Of::faces, "both", {on[5], inside[7]}},
                 {Group::Of::cells, "zone", {1, 2}}};
        writer.add_mesh(made.mesh, made.original_vertex, made.original_cell, named);
        writer.add_step(0, 0, 0, {});
        writer.finish();
        dataset = store::Dataset::open(folder / "zoo.ciel");
    }
    // Makes the surface from all faces of the mesh that was stored.
    [[nodiscard]] Surface expected(const std::vector<std::string>& groups, std::span<const std::uint8_t> kept) const {
        FaceMeshView mesh = made.mesh.view();
        mesh.surface_origin = origin;
        std::vector<Index> ids;
        for (const store::NamedGroup& group : named)
            if (group.of == store::Group::Of::faces && std::ranges::find(groups, group.name) != groups.end())
                ids.insert(ids.end(), group.ids.begin(), group.ids.end());
        if (groups.empty() && !kept.empty()) return threshold_surface(mesh, kept);
        return face_surface(mesh, groups.empty() ? boundary_faces(mesh) : faces_by_id(mesh, ids, kept));
    }

    [[nodiscard]] std::vector<std::uint8_t> some_cells() const {
        std::vector<std::uint8_t> some(dataset->info().meshes[0].cells);
        for (std::size_t cell = 0; cell < some.size(); ++cell) some[cell] = cell % 3 != 0 ? 1 : 0;
        return some;
    }

    const Vec3d origin{0.5, -1, 2};
    const Assembled made = assemble(test::view(test::zoo({{5, 4, 4}, 0, 5, 1})));
    std::vector<store::NamedGroup> named;
    test::Folder folder;
    std::shared_ptr<store::Dataset> dataset;
};

// A polygon as its cell and its corners, starting at the lowest vertex. A corner is a vertex and its position.
using Corners = std::vector<std::pair<Index, Vec3f>>;
std::multiset<std::pair<Index, Corners>> polygons_of(const Surface& surface) {
    std::multiset<std::pair<Index, Corners>> all;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        Corners corners;
        for (Index k = surface.polygon_offset[i]; k < surface.polygon_offset[i + 1]; ++k) {
            const Index point = surface.polygon_vertex[k];
            corners.emplace_back(surface.points[point].a, surface.positions[point]);
        }
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        all.emplace(surface.polygon_cell[i], corners);
    }
    return all;
}

TEST_F(BoundarySurface, IsThatOfAllFaces) {
    const std::vector<std::vector<std::string>> choices{{},       {"wall"},        {"lid", "wall"}, {"baffle"},
                                                        {"both"}, {"lid", "both"}, {"zone"}};
    store::LoadedDataset loaded(dataset, 1 << 20);
    for (const auto& groups : choices)
        for (const std::vector<std::uint8_t>& kept : {std::vector<std::uint8_t>(), some_cells()}) {
            const Surface found = boundary_surface(loaded, 0, origin, groups, kept);
            const Surface wanted = expected(groups, kept);
            EXPECT_EQ(polygons_of(found), polygons_of(wanted)) << (groups.empty() ? "all" : groups.back());
            const FaceMeshView faces = dataset->mesh_arrays().numbered_faces(0, 0);
            for (std::size_t i = 0; i < found.polygon_face.size(); ++i)
                if (found.polygon_face[i] != none) {
                    EXPECT_EQ(faces.owner[found.polygon_face[i]], found.polygon_cell[i]);
                }
        }
}

TEST_F(BoundarySurface, FacesOfAGroupHaveTheirVertices) {
    const FaceMeshView all = made.mesh.view(), faces = dataset->mesh_arrays().numbered_faces(0, 0);
    const std::vector<store::Group> groups = dataset->groups(0);
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i].of != store::Group::Of::faces) continue;
        const std::vector<Index> ids(groups[i].ids.begin(), groups[i].ids.end());
        ASSERT_EQ(ids.size(), named[i].ids.size());
        EXPECT_NEAR(size_of_faces(faces, ids).area, size_of_faces(all, named[i].ids).area, 1e-6) << named[i].name;
    }
}

} // namespace
} // namespace server::geometry
