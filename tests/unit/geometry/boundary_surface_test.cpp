// The polygons of boundaries and patches are those of the list of all faces, whichever list they were made from.
#include "ciel/assemble.hpp"
#include "ciel/mesh_faces.hpp"
#include "geometry/cut.hpp"
#include "store/group_faces.hpp"
#include "store/writer.hpp"
#include "support/folder.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <set>

namespace ciel::geometry {
namespace {

// Groups on the boundary, inside the mesh, and on both.
class BoundarySurface : public testing::Test {
protected:
    BoundarySurface() {
        const Assembled made = assemble(test::view(test::zoo({{5, 4, 4}, 0, 5, 1})));
        std::vector<Index> on, inside;
        for (Index face = 0; face < made.mesh.owner.size(); ++face)
            (made.mesh.neighbour[face] == none ? on : inside).push_back(face);
        store::Writer writer(folder / "zoo.ciel", {});
        using store::Group;
        writer.add_mesh(made.mesh, made.original_vertex, made.original_cell,
                        std::vector<store::NamedGroup>{{Group::Of::faces, "wall", {on[2], on[9], on[40]}},
                                                       {Group::Of::faces, "lid", {on[3], on[9]}},
                                                       {Group::Of::faces, "baffle", {inside[7], inside[8]}},
                                                       {Group::Of::faces, "both", {on[5], inside[7]}},
                                                       {Group::Of::cells, "zone", {1, 2}}});
        writer.add_step(0, 0, 0, {});
        writer.finish();
        dataset = store::Dataset::open(folder / "zoo.ciel");
    }
    [[nodiscard]] Surface expected(const std::vector<std::string>& groups, std::span<const std::uint8_t> kept) const {
        FaceMeshView mesh = dataset->mesh(0, 0);
        mesh.surface_origin = origin;
        std::vector<Index> ids;
        for (const store::Group& group : dataset->groups(0))
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
    test::Folder folder;
    std::shared_ptr<store::Dataset> dataset;
};

// A polygon as its cell and its corners from the lowest vertex on: vertices and their places.
using Corners = std::vector<std::pair<Index, Vec3f>>;
std::multiset<std::pair<Index, Corners>> polygons_of(const Surface& surface) {
    std::multiset<std::pair<Index, Corners>> all;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        Corners corners;
        for (Index k = surface.polygon_offset[i]; k < surface.polygon_offset[i + 1]; ++k) {
            const Index point = surface.polygon_vertex[k];
            corners.emplace_back(surface.points[point].a, surface.positions[point]);
        }
        std::ranges::rotate(corners, std::ranges::min_element(corners));
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
            const std::string name = groups.empty() ? "all" : groups.back();
            if (groups.empty() && !kept.empty()) {
                EXPECT_EQ(polygons_of(found), polygons_of(wanted));
                continue;
            }
            EXPECT_EQ(found.positions, wanted.positions) << name;
            EXPECT_EQ(found.polygon_offset, wanted.polygon_offset) << name;
            EXPECT_EQ(found.polygon_vertex, wanted.polygon_vertex) << name;
            EXPECT_EQ(found.polygon_cell, wanted.polygon_cell) << name;
            EXPECT_EQ(found.polygon_face, wanted.polygon_face) << name;
            for (std::size_t i = 0; i < found.points.size(); ++i) EXPECT_EQ(found.points[i].a, wanted.points[i].a);
        }
}

// Points of the whole mesh and the boundary of a threshold are made without the list of all faces.
TEST_F(BoundarySurface, OfAThresholdReadsNoListOfFaces) {
    for (const char* name : {"face_offset", "face_vertex", "owner", "neighbour"}) {
        const auto file = folder / "zoo.ciel/meshes/0" / name / "0";
        const std::string noise(std::filesystem::file_size(file), '\7');
        std::ofstream(file, std::ios::binary) << noise;
    }
    store::LoadedDataset loaded(store::Dataset::open(folder / "zoo.ciel"), 1 << 20);
    const std::vector<std::uint8_t> kept = some_cells();
    EXPECT_GT(boundary_surface(loaded, 0, origin, {}, kept).polygon_cell.size(), 0U);
    EXPECT_GT(boundary_surface(loaded, 0, origin, {"wall"}, kept).polygon_cell.size(), 0U);
    EXPECT_THROW((void)boundary_surface(loaded, 0, origin, {"baffle"}, kept), Error) << "the lists are not damaged";
}

TEST_F(BoundarySurface, FacesOfAGroupHaveTheirVertices) {
    const FaceMeshView all = dataset->mesh(0, 0);
    for (const store::Group& group : dataset->groups(0)) {
        if (group.of != store::Group::Of::faces) continue;
        const store::GroupFaces faces = store::faces_of(group, *dataset, dataset->steps()[0]);
        ASSERT_EQ(faces.ids.size(), group.ids.size());
        for (std::size_t i = 0; i < faces.ids.size(); ++i)
            EXPECT_TRUE(std::ranges::equal(faces.mesh.loop(faces.ids[i]), all.loop(group.ids[i]))) << group.name;
        EXPECT_EQ(size_of_faces(faces.mesh, faces.ids).area,
                  size_of_faces(all, std::vector<Index>(group.ids.begin(), group.ids.end())).area);
    }
}

} // namespace
} // namespace ciel::geometry
