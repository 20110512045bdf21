// The polygons of boundaries and patches are those of the list of all faces, whichever list they were made from.
#include "ciel/assemble.hpp"
#include "ciel/mesh_faces.hpp"
#include "geometry/cut.hpp"
#include "store/group_faces.hpp"
#include "store/writer.hpp"
#include "support/folder.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <gtest/gtest.h>

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
        return face_surface(mesh, groups.empty() ? boundary_faces(mesh, kept) : faces_by_id(mesh, ids, kept));
    }

    const Vec3d origin{0.5, -1, 2};
    test::Folder folder;
    std::shared_ptr<store::Dataset> dataset;
};

TEST_F(BoundarySurface, IsThatOfAllFaces) {
    const std::vector<std::vector<std::string>> choices{{},       {"wall"},        {"lid", "wall"}, {"baffle"},
                                                        {"both"}, {"lid", "both"}, {"zone"}};
    std::vector<std::uint8_t> some(dataset->mesh(0, 0).cell_count());
    for (std::size_t cell = 0; cell < some.size(); ++cell) some[cell] = cell % 3 != 0 ? 1 : 0;
    for (const auto& groups : choices)
        for (const std::vector<std::uint8_t>& kept : {std::vector<std::uint8_t>(), some}) {
            const Surface found = boundary_surface(*dataset, dataset->steps()[0], origin, groups, kept);
            const Surface wanted = expected(groups, kept);
            const std::string name = groups.empty() ? "all" : groups.back();
            EXPECT_EQ(found.positions, wanted.positions) << name;
            EXPECT_EQ(found.polygon_offset, wanted.polygon_offset) << name;
            EXPECT_EQ(found.polygon_vertex, wanted.polygon_vertex) << name;
            EXPECT_EQ(found.polygon_cell, wanted.polygon_cell) << name;
            EXPECT_EQ(found.polygon_face, wanted.polygon_face) << name;
            for (std::size_t i = 0; i < found.points.size(); ++i) EXPECT_EQ(found.points[i].a, wanted.points[i].a);
        }
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
