// Surfaces colored by a cell array: every polygon has the value of its cell, and no value is interpolated.
#include "geometry/surface_values.hpp"

#include "geometry/clip.hpp"
#include "probe/visible_range.hpp"
#include "store/catalog.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::geometry {
using namespace ciel;
namespace {

using nlohmann::json;

class flat_values : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<test::Folder>();
        test::write_small_dataset(folder->path() / "box.ciel");
    }
    static void TearDownTestSuite() { folder.reset(); }

    std::shared_ptr<const Geometry> show(json layers) {
        return geometry.update({scene::parse({{"dataset", "box"}, {"layers", std::move(layers)}}), loaded});
    }
    static json by_cells(json layer) {
        layer["color"] = {{"array", "cell:q"}};
        return layer;
    }
    // Expects that the three corners of each triangle have the value of their polygon's cell.
    void expect_flat(const Drawable& drawable) const {
        const auto of_cells = loaded->stored_scalar("cell:q", 0, store::Association::cell)->all();
        const Surface& surface = drawable.shape->surface;
        ASSERT_TRUE(drawable.scalars);
        ASSERT_EQ(drawable.scalars->size(), surface.positions.size());
        for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i)
            for (Index k = surface.polygon_offset[i]; k < surface.polygon_offset[i + 1]; ++k)
                ASSERT_EQ((*drawable.scalars)[surface.polygon_vertex[k]], of_cells[surface.polygon_cell[i]]);
        for (std::size_t i = 0; i < drawable.shape->indices.size(); i += 3)
            for (const std::size_t corner : {1U, 2U})
                ASSERT_EQ((*drawable.scalars)[drawable.shape->indices[i]],
                          (*drawable.scalars)[drawable.shape->indices[i + corner]]);
    }

    static std::unique_ptr<test::Folder> folder;
    store::Catalog catalog{{folder->path()}};
    std::shared_ptr<store::LoadedDataset> loaded = catalog.open("box");
    SceneGeometry geometry{Algorithm::signatures};
};
std::unique_ptr<test::Folder> flat_values::folder;

const json iso{{"type", "iso"}, {"array", "p"}, {"values", {12}}};
const json slice{{"type", "slice"}, {"axis", "x"}, {"value", test::box_origin[0] + 1.5}};
const json surface{{"type", "surface"}};

TEST_F(flat_values, are_on_boundaries_slices_and_iso_surfaces) {
    for (const json& layer : {iso, slice, surface}) {
        const auto plain = show({{"a", layer}});
        const auto flat = show({{"a", by_cells(layer)}});
        ASSERT_EQ(flat->drawables.size(), 1U) << layer;
        expect_flat(flat->drawables[0]);
        EXPECT_EQ(flat->triangles, plain->triangles) << layer;
        EXPECT_EQ(flat->drawables[0].shape->surface.normals.empty(),
                  plain->drawables[0].shape->surface.normals.empty());
        EXPECT_EQ(flat->drawables[0].array, "cell:q");
    }
}

TEST_F(flat_values, are_on_caps_and_on_what_a_threshold_keeps) {
    json clip{{"type", "clip"}, {"axis", "x"}, {"value", test::box_origin[0] + 1.5}};
    json layer = by_cells(surface);
    layer["threshold"] = {{"array", "cell:q"}, {"range", {3, 90}}};
    const auto shown = show({{"a", layer}, {"c", clip}});
    ASSERT_EQ(shown->drawables.size(), 2U) << "the boundary and the cap";
    for (const Drawable& drawable : shown->drawables) expect_flat(drawable);
    const auto cut = clipped(*shown, shown->drawables[0]);
    const auto of_cells = loaded->stored_scalar("cell:q", 0, store::Association::cell)->all();
    ASSERT_FALSE(cut.surface.polygon_cell.empty());
    for (std::size_t i = 0; i < cut.surface.polygon_cell.size(); ++i)
        for (Index k = cut.surface.polygon_offset[i]; k < cut.surface.polygon_offset[i + 1]; ++k)
            EXPECT_EQ(cut.values[cut.surface.polygon_vertex[k]], of_cells[cut.surface.polygon_cell[i]]);
}

TEST_F(flat_values, leave_edges_and_contour_lines_as_they_are) {
    json layer = slice;
    layer["edges"] = json::object();
    layer["contours"] = {{"array", "p"}};
    const auto plain = show({{"a", layer}});
    const auto flat = show({{"a", by_cells(layer)}});
    ASSERT_EQ(plain->drawables.size(), flat->drawables.size());
    for (std::size_t i = 1; i < flat->drawables.size(); ++i)
        EXPECT_EQ(plain->drawables[i].indices().size(), flat->drawables[i].indices().size());
}

TEST_F(flat_values, have_the_range_of_the_cells_that_are_seen) {
    const json layer = by_cells(slice);
    const scene::CheckedScene checked(scene::parse({{"dataset", "box"}, {"layers", {{"a", layer}}}}), loaded);
    const auto shown = geometry.update(checked);
    const auto range = probe::visible_range(*shown, checked, {"a"}, std::nullopt, false);
    const auto [low, high] =
        std::minmax_element(shown->drawables[0].scalars->begin(), shown->drawables[0].scalars->end());
    ASSERT_TRUE(range.has_value());
    EXPECT_EQ((*range)[0], *low);
    EXPECT_EQ((*range)[1], *high);
}

TEST_F(flat_values, keep_the_separated_polygons_while_only_the_step_changes) {
    const json layer = by_cells(surface);
    const auto first = show({{"a", layer}});
    const auto again = show({{"a", layer}});
    EXPECT_EQ(first->drawables[0].shape, again->drawables[0].shape);
    EXPECT_EQ(first->drawables[0].revision, again->drawables[0].revision);
    const auto by_points = show({{"a", surface}});
    EXPECT_LT(by_points->drawables[0].shape->surface.positions.size(),
              first->drawables[0].shape->surface.positions.size());
    EXPECT_GT(first->bytes, by_points->bytes) << "the separated polygons are counted";
}

TEST_F(flat_values, say_why_contour_lines_have_none) {
    json layer = slice;
    layer["contours"] = {{"array", "cell:q"}};
    try {
        show({{"a", layer}});
        ADD_FAILURE() << "was accepted";
    } catch (const scene::Invalid& error) {
        EXPECT_EQ(error.path, "/layers/a/contours/array");
        EXPECT_THAT(error.what(), testing::HasSubstr("cell:q has a value per cell, and contour lines are made from "
                                                     "values at points; choose an array on points"));
    }
}

} // namespace
} // namespace server::geometry
