// Compares the box around what clips and thresholds leave with known boxes. The dataset goes from 0 to 6 along each
// axis, relative to box_origin; p = x + 2 y + 3 z, U:x = z.
#include "probe/shown_bounds.hpp"

#include "store/catalog.hpp"
#include "support/chosen_algorithm.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::probe {
using namespace ciel;
namespace {

using nlohmann::json;

json clip(const char* axis, double at, bool invert = false) {
    const auto k = static_cast<std::size_t>(axis[0] - 'x');
    return {{"type", "clip"}, {"axis", axis}, {"value", test::box_origin[k] + at}, {"invert", invert}};
}
json free_clip(const Vec3d& through, const Vec3d& normal) {
    Vec3d origin = through;
    for (std::size_t k = 0; k < 3; ++k) origin[k] += test::box_origin[k];
    return {{"type", "clip"}, {"origin", origin}, {"normal", normal}};
}
const json surface{{"type", "surface"}};
const json lowest{{"type", "surface"}, {"threshold", {{"array", "U:x"}, {"range", {0, 1.25}}}}};
const json highest{{"type", "points"}, {"threshold", {{"array", "U:x"}, {"range", {5, 6}}}}};
const json slice{{"type", "slice"}, {"axis", "z"}, {"value", test::box_origin[2] + 1}};
const json outline{{"type", "outline"}};
const json volume{{"type", "volume"}, {"array", "p"}, {"slices", 20}};

struct Row {
    const char* what;
    json layers;
    Vec3d low, high; // relative to box_origin
};

TEST(ShownBounds, AreThoseOfWhatClipsAndThresholdsLeave) {
    test::Folder folder;
    test::write_small_dataset(folder / "box.ciel");
    store::Catalog catalog{{folder.path()}};
    geometry::SceneGeometry geometry(test::chosen_algorithm());
    json hidden = clip("x", 1);
    hidden["visible"] = false;
    const Vec3d none{0, 0, 0}, all{6, 6, 6};
    const std::vector<Row> rows{
        {"everything", {{"a", surface}}, none, all},
        {"a slice narrows nothing", {{"a", slice}, {"o", outline}}, none, all},
        {"a clip", {{"a", surface}, {"c", clip("x", 2)}}, none, {2, 6, 6}},
        {"a clip that is switched off", {{"a", surface}, {"c", hidden}}, none, all},
        {"of a volume", {{"a", volume}, {"c", clip("y", 2, true)}}, {0, 2, 0}, all},
        {"two clips", {{"a", slice}, {"c", clip("x", 2)}, {"d", clip("z", 5, true)}}, {0, 0, 5}, {2, 6, 6}},
        {"a corner cut by a free plane", {{"a", surface}, {"c", free_clip({3, 0, 0}, {1, 1, 1})}}, none, {3, 3, 3}},
        {"planes that leave nothing", {{"a", surface}, {"c", clip("x", -1)}}, none, all},
        {"a threshold", {{"a", lowest}}, none, {6, 6, 1}},
        {"with the outline", {{"a", lowest}, {"o", outline}}, none, {6, 6, 1}},
        {"two thresholds", {{"a", lowest}, {"b", highest}}, none, all},
        {"one beside a layer of everything", {{"a", lowest}, {"b", slice}}, none, all},
        {"a threshold and a clip", {{"a", lowest}, {"c", clip("x", 2.5)}}, none, {2.5, 6, 1}},
        {"nothing", json::object(), none, all},
        {"an outline alone, clipped", {{"o", outline}, {"c", clip("x", 2)}}, none, {2, 6, 6}},
    };
    for (const Row& row : rows) {
        const scene::CheckedScene checked(scene::parse({{"dataset", "box"}, {"layers", row.layers}}),
                                          catalog.open("box"));
        const auto shown = geometry.update(checked);
        const geometry::BoundingBox found = shown_bounds(*shown, checked);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(found.low[k] - test::box_origin[k], row.low[k], 1e-4) << row.what;
            EXPECT_NEAR(found.high[k] - test::box_origin[k], row.high[k], 1e-4) << row.what;
        }
    }
}

TEST(DrawnBounds, AreThoseOfWhatTheLayersDraw) {
    test::Folder folder;
    test::write_small_dataset(folder / "box.ciel");
    store::Catalog catalog{{folder.path()}};
    geometry::SceneGeometry geometry(test::chosen_algorithm());
    const json body{{"type", "surface"}, {"groups", {"body"}}};
    const json left{{"type", "edges"}, {"groups", {"left"}}};
    const json iso{{"type", "iso"}, {"array", "U:x"}, {"values", {5}}}; // the plane z = 5
    json hidden = body;
    hidden["visible"] = false;
    const Vec3d none{0, 0, 0}, all{6, 6, 6}, hole{2, 2, 2}, hole_end{4, 4, 4};
    const std::vector<Row> rows{
        {"everything", {{"a", surface}}, none, all},
        {"a patch", {{"a", body}}, hole, hole_end},
        {"a patch in the far field's slice and outline", {{"a", body}, {"s", slice}, {"o", outline}}, hole, hole_end},
        {"a patch and all of the boundary", {{"a", body}, {"b", surface}}, hole, hole_end},
        {"a patch that is switched off", {{"a", hidden}, {"b", surface}}, none, all},
        {"two patches", {{"a", body}, {"b", left}}, none, {4, 6, 6}},
        {"a patch and an iso-surface", {{"a", body}, {"i", iso}}, {0, 0, 2}, {6, 6, 5}},
        {"an iso-surface alone", {{"i", iso}, {"o", outline}}, {0, 0, 5}, {6, 6, 5}},
        {"a slice alone", {{"a", slice}}, {0, 0, 1}, {6, 6, 1}},
        {"a slice and an iso-surface", {{"a", slice}, {"i", iso}}, {0, 0, 1}, {6, 6, 5}},
        {"a clipped patch", {{"a", body}, {"c", clip("x", 3)}}, hole, {3, 4, 4}},
        {"a patch that is clipped away", {{"a", body}, {"s", slice}, {"c", clip("x", 1)}}, {0, 0, 1}, {1, 6, 1}},
        {"a volume", {{"v", volume}, {"c", clip("y", 2, true)}}, {0, 2, 0}, all},
        {"an outline alone", {{"o", outline}}, none, all},
    };
    for (const Row& row : rows) {
        const scene::CheckedScene checked(scene::parse({{"dataset", "box"}, {"layers", row.layers}}),
                                          catalog.open("box"));
        const auto shown = geometry.update(checked);
        const geometry::BoundingBox found = drawn_bounds(*shown, checked);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(found.low[k] - test::box_origin[k], row.low[k], 1e-4) << row.what;
            EXPECT_NEAR(found.high[k] - test::box_origin[k], row.high[k], 1e-4) << row.what;
        }
    }
}

TEST(BoundsInView, AreThoseOfThePointsThatThePictureShows) {
    test::Folder folder;
    test::write_small_dataset(folder / "box.ciel");
    store::Catalog catalog{{folder.path()}};
    geometry::SceneGeometry geometry(test::chosen_algorithm());
    const json body{{"type", "surface"}, {"groups", {"body"}}};
    const Vec3d& o = test::box_origin;
    const auto found = [&](json layers, double height, double x = 3) {
        const json camera{{"position", {o[0] + x, o[1] + 3, o[2] + 30}},
                          {"target", {o[0] + x, o[1] + 3, o[2]}},
                          {"up", {0, 1, 0}},
                          {"parallel", true},
                          {"parallel_height", height}};
        const scene::CheckedScene checked(
            scene::parse({{"dataset", "box"}, {"camera", camera}, {"layers", std::move(layers)}}), catalog.open("box"));
        return bounds_in_view(*geometry.update(checked), checked, {100, 100, 1});
    };
    const auto expect = [&](const std::optional<geometry::BoundingBox>& box, const Vec3d& low, const Vec3d& high) {
        ASSERT_TRUE(box);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(box->low[k] - o[k], low[k], 1e-4);
            EXPECT_NEAR(box->high[k] - o[k], high[k], 1e-4);
        }
    };
    expect(found({{"a", surface}}, 20), {0, 0, 0}, {6, 6, 6});
    expect(found({{"a", surface}}, 2.5), {2, 2, 0}, {4, 4, 6});
    expect(found({{"a", surface}, {"b", body}}, 20), {2, 2, 2}, {4, 4, 4});
    expect(found({{"a", surface}, {"b", body}, {"c", clip("x", 3)}}, 20), {2, 2, 2}, {3, 4, 4});
    EXPECT_FALSE(found({{"o", outline}}, 20));
    EXPECT_FALSE(found({{"a", surface}}, 20, 100));
}

} // namespace
} // namespace server::probe
