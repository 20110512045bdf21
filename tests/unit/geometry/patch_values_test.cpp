// The solver's values on the faces of patches (patch:p) color boundaries, one color for each face. Other uses are
// refused.
#include "geometry/scene_geometry.hpp"
#include "store/catalog.hpp"
#include "store/no_value.hpp"
#include "store/writer.hpp"
#include "support/folder.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::geometry {
using namespace ciel;
namespace {

using nlohmann::json;
using testing::HasSubstr;

// 3 x 3 x 3 hexahedra. The value of patch:p on a boundary face is the face's number. The last face has no value.
class patch_values : public testing::Test {
protected:
    patch_values() {
        const Assembled made = assemble(test::view(test::hexahedra({{3, 3, 3}})));
        mesh = made.mesh;
        std::vector<Index> boundary;
        for (Index face = 0; face < mesh.owner.size(); ++face)
            if (mesh.neighbour[face] == none) boundary.push_back(face);
        std::vector<float> faces(boundary.size());
        for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = static_cast<float>(i);
        faces.back() = store::no_value;
        const std::vector<float> points(mesh.positions.size() / 3, 1);
        store::Writer writer(folder.path() / "box.ciel", {});
        writer.add_mesh(mesh, made.original_vertex, made.original_cell,
                        std::vector<store::NamedGroup>{{store::Group::Of::faces, "some", {boundary[2], boundary[9]}}});
        writer.add_step(
            0, 0, 0,
            std::vector<store::ArrayValues>{{{"p", store::Association::point, 1, "", ""}, points},
                                            {{"patch:p", store::Association::boundary_face, 1, "", ""}, faces}});
        writer.finish();
        loaded = catalog.open("box");
    }
    std::shared_ptr<const Geometry> show(json layers) {
        return geometry.update({scene::parse({{"dataset", "box"}, {"layers", std::move(layers)}}), loaded});
    }
    std::string refusal(const json& layer) {
        try {
            show({{"a", layer}});
        } catch (const scene::Invalid& error) {
            return error.what();
        }
        return "";
    }

    FaceMesh mesh;
    test::Folder folder;
    store::Catalog catalog{{folder.path()}};
    std::shared_ptr<store::LoadedDataset> loaded;
    SceneGeometry geometry{Algorithm::signatures};
};

const json by_patches{{"array", "patch:p"}};

TEST_F(patch_values, are_flat_on_each_face) {
    const auto shown = show({{"a", {{"type", "surface"}, {"color", by_patches}}}});
    const Drawable& drawable = shown->drawables.at(0);
    const Surface& surface = drawable.shape->surface;
    ASSERT_EQ(surface.polygon_face.size(), 54U);
    const std::vector<Index>& numbers = surface.polygon_face;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        for (Index k = surface.polygon_offset[i]; k < surface.polygon_offset[i + 1]; ++k) {
            const float value = (*drawable.scalars)[surface.polygon_vertex[k]];
            if (numbers[i] == 53)
                EXPECT_TRUE(std::isnan(value)) << "the face without a value stays, in the color of no value";
            else
                EXPECT_EQ(value, static_cast<float>(numbers[i]));
        }
    EXPECT_TRUE(drawable.missing);
}

TEST_F(patch_values, of_single_patches_are_those_of_their_faces) {
    const auto shown = show({{"a", {{"type", "surface"}, {"groups", {"some"}}, {"color", by_patches}}}});
    const Drawable& drawable = shown->drawables.at(0);
    ASSERT_EQ(drawable.shape->surface.polygon_face.size(), 2U);
    EXPECT_EQ((*drawable.scalars)[0], 2);
    EXPECT_EQ((*drawable.scalars)[drawable.scalars->size() - 1], 9);
}

TEST_F(patch_values, are_none_inside_so_that_caps_have_those_of_points) {
    const json clip{{"type", "clip"}, {"axis", "x"}, {"value", 1.5}};
    const auto shown = show({{"a", {{"type", "surface"}, {"color", by_patches}}}, {"c", clip}});
    ASSERT_EQ(shown->drawables.size(), 2U);
    EXPECT_EQ(shown->drawables[0].array, "patch:p");
    EXPECT_EQ(shown->drawables[1].array, "p");
}

TEST_F(patch_values, are_refused_in_words_elsewhere) {
    const json slice{{"type", "slice"}, {"axis", "x"}, {"value", 1.5}, {"color", by_patches}};
    EXPECT_THAT(refusal(slice), HasSubstr("patch:p has values only on the faces of patches, which can color surface "
                                          "layers only; choose an array on points"));
    const json iso{{"type", "iso"}, {"array", "patch:p"}, {"values", {1}}};
    EXPECT_THAT(refusal(iso), HasSubstr("only on the faces of patches"));
    const json chosen{{"type", "surface"}, {"threshold", {{"array", "patch:p"}, {"range", {0, 1}}}}};
    EXPECT_THAT(refusal(chosen), HasSubstr("only on the faces of patches"));
}

} // namespace
} // namespace server::geometry
