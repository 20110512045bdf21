// Visible layers that show nothing are named with the reason, and have no legend. The dataset is a box that goes from 0
// to 6 along each axis, relative to box_origin.
#include "geometry/empty_layers.hpp"

#include "geometry/scene_annotations.hpp"
#include "store/catalog.hpp"
#include "support/chosen_algorithm.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::geometry {
using namespace ciel;
namespace {

using nlohmann::json;
using Why = EmptyLayer::Why;

class EmptyLayers : public testing::Test {
protected:
    EmptyLayers() { test::write_small_dataset(folder / "box.ciel"); }

    const Geometry& show(const json& layers) {
        checked.emplace(scene::parse({{"dataset", "box"}, {"layers", layers}}), catalog.open("box"));
        shown = geometry.update(*checked);
        return *shown;
    }
    std::size_t legends() { return annotations_of(*shown, *checked).legends.size(); }
    std::size_t legends_in_the_way() { return annotations_of(*shown, *checked, LegendsOf::all_layers).legends.size(); }

    test::Folder folder;
    store::Catalog catalog{{folder.path()}};
    SceneGeometry geometry{test::chosen_algorithm()};
    std::optional<scene::CheckedScene> checked;
    std::shared_ptr<const Geometry> shown;
};

json colored(json layer) {
    layer["color"] = {{"array", "p"}};
    return layer;
}
const json surface = colored({{"type", "surface"}});
const json volume{{"type", "volume"}, {"array", "p"}, {"slices", 20}};

json with(json layer, const std::string& name, const json& value) {
    layer[name] = value;
    return layer;
}
json clip(const char* axis, double at, bool invert = false) {
    const std::size_t k = axis[0] - 'x';
    return {{"type", "clip"}, {"axis", axis}, {"value", test::box_origin[k] + at}, {"invert", invert}};
}
json threshold(double low, double high) { return {{"array", "p"}, {"range", {low, high}}}; }

struct Row {
    json layer;
    Why why;
    std::string reason;
};

TEST_F(EmptyLayers, AreNamedWithTheReasonAndHaveNoLegend) {
    const json slice = colored({{"type", "slice"}, {"axis", "z"}, {"value", 7}});
    const json iso = colored({{"type", "iso"}, {"array", "p"}, {"values", {100}}});
    const std::vector<Row> rows{
        {slice, Why::outside, "The plane does not cut the data."},
        {iso, Why::outside, "100 is outside the range: p goes from 0 to 36 at this time."},
        {with(iso, "values", {-1, 99}), Why::outside,
         "The iso-values are outside the range: p goes from 0 to 36 at this time."},
        {with(surface, "threshold", threshold(50, 60)), Why::threshold,
         "The threshold from 50 to 60 keeps no cell: p goes from 0 to 36 at this time."},
        {with(colored({{"type", "edges"}}), "threshold", threshold(50, 60)), Why::threshold,
         "The threshold from 50 to 60 keeps no cell: p goes from 0 to 36 at this time."},
        {colored({{"type", "edges"}, {"angle", 170}}), Why::nothing, "The data has no geometry of the layer's type."},
        {with(surface, "opacity", 0), Why::opacity, "The opacity is 0."},
        {with(volume, "opacity", 0), Why::opacity, "The opacity is 0."},
        {with(volume, "opacity_points", json::parse("[[0, 0], [1, 0]]")), Why::opacity, "The opacity is 0."},
    };
    for (const Row& row : rows) {
        const Geometry& now = show({{"a", row.layer}});
        ASSERT_EQ(now.empty.size(), 1U) << row.layer;
        EXPECT_EQ(now.empty[0].layer, "a");
        EXPECT_EQ(now.empty[0].why, row.why) << row.layer;
        EXPECT_EQ(now.empty[0].reason, row.reason);
        EXPECT_EQ(legends(), 0U) << row.layer;
        EXPECT_EQ(legends_in_the_way(), 1U) << "the view stays where it is: " << row.layer;
    }
}

TEST_F(EmptyLayers, AnIsoSurfaceWithoutAValueIsOne) {
    const Geometry& now = show({{"a", {{"type", "iso"}, {"array", "p"}, {"values", json::array()}}}});
    ASSERT_EQ(now.empty.size(), 1U);
    EXPECT_EQ(now.empty[0].reason, "The layer has no iso-value.");
}

TEST_F(EmptyLayers, WhatIsSeenIsNot) {
    for (const json& layer :
         {surface, volume, with(surface, "opacity", 0.01), with(surface, "threshold", threshold(0, 60)),
          colored({{"type", "iso"}, {"array", "p"}, {"values", {-1, 9}}}), colored({{"type", "points"}}),
          colored({{"type", "edges"}})}) {
        EXPECT_TRUE(show({{"a", layer}}).empty.empty()) << layer;
        EXPECT_EQ(legends(), 1U) << layer;
        EXPECT_TRUE(show({{"a", layer}, {"c", clip("x", 5.9)}, {"d", clip("y", 0.1)}}).empty.empty()) << layer;
    }
    EXPECT_TRUE(show({{"o", {{"type", "outline"}}}, {"c", clip("x", -1)}}).empty.empty()) << "these show no data";
    EXPECT_TRUE(show({{"a", with(with(surface, "opacity", 0), "visible", false)}}).empty.empty()) << "switched off";
}

TEST_F(EmptyLayers, AreThoseThatPlanesCutAwayWhole) {
    for (const json& layer : {surface, volume, colored({{"type", "points"}}), colored({{"type", "edges"}})}) {
        const Geometry& now = show({{"a", layer}, {"c", clip("x", -0.5)}});
        ASSERT_EQ(now.empty.size(), 1U) << layer;
        EXPECT_EQ(now.empty[0].why, Why::clipped);
        EXPECT_EQ(now.empty[0].reason, "The clip planes cut away the whole layer.");
        EXPECT_EQ(legends(), 0U);
    }
    // Between these planes are parts of cells, but no vertex of the lattice. The same planes inverted keep nothing.
    const json between{{"a", surface}, {"c", clip("x", 2.7)}, {"d", clip("x", 2.3, true)}};
    EXPECT_TRUE(show(between).empty.empty());
    const json beyond{{"a", surface}, {"c", clip("x", 2.3)}, {"d", clip("x", 2.7, true)}};
    EXPECT_EQ(show(beyond).empty.size(), 1U);
}

// Clip planes that leave at most a thin sheet or a corner of the box leave no geometry. Otherwise caps would be drawn
// on both sides of the sheet.
TEST_F(EmptyLayers, AreAllWherePlanesLeaveNoMoreThanASheet) {
    const json slice = colored({{"type", "slice"}, {"axis", "x"}, {"value", test::box_origin[0] + 2.3}});
    json oblique{{"type", "clip"}, {"origin", test::box_origin}, {"normal", {1, 1, 1}}, {"invert", false}};
    const std::vector<json> planes{
        {{"c", clip("x", 2.3)}, {"d", clip("x", 2.3, true)}},
        {{"c", clip("x", 2.3)}, {"d", clip("x", 2.3 - 1e-5, true)}},
        {{"c", clip("z", 0)}},
        {{"c", oblique}}, // leaves one corner of the box
        {{"b", clip("y", 1)}, {"c", clip("x", 2.3)}, {"d", clip("x", 2.3, true)}},
    };
    for (json layers : planes)
        for (const json& layer : {surface, volume, slice, colored({{"type", "points"}})}) {
            layers["a"] = layer;
            const Geometry& now = show(layers);
            ASSERT_EQ(now.empty.size(), 1U) << layers;
            EXPECT_EQ(now.empty[0].reason, "The clip planes cut away the whole layer.");
        }
    EXPECT_TRUE(show({{"a", surface}, {"c", clip("x", 2.301)}, {"d", clip("x", 2.3, true)}}).empty.empty());
}

TEST_F(EmptyLayers, AreThoseWhoseArrayWasNotWritten) {
    const Geometry& now = show({{"a", {{"type", "iso"}, {"array", "late"}, {"values", {1}}}}});
    ASSERT_EQ(now.empty.size(), 1U);
    EXPECT_EQ(now.empty[0].why, Why::missing);
    EXPECT_THAT(now.empty[0].reason, testing::HasSubstr("has no values at time 0"));
}

} // namespace
} // namespace server::geometry
