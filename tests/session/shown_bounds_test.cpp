// What clips and thresholds leave, as a box: against boxes that are known. The dataset goes from 0 to 6 along each
// axis, beside its origin; p = x + 2 y + 3 z, U:x = z.
#include "session/shown_bounds.hpp"

#include "small_dataset/small_dataset.hpp"
#include "store/catalog.hpp"
#include "support/chosen_engine.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ciel::session {
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
    Vec3d low, high; // beside the origin
};

TEST(ShownBounds, AreThoseOfWhatClipsAndThresholdsLeave) {
    test::Folder folder;
    test::write_small_dataset(folder / "box.ciel");
    store::Catalog catalog{{folder.path()}};
    SceneGeometry geometry(test::chosen_engine());
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
        const scene::Scene scene = scene::parse({{"dataset", "box"}, {"layers", row.layers}});
        const auto shown = geometry.update(scene, catalog.open("box"));
        const BoundingBox found = shown_bounds(*shown, scene);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(found.low[k] - test::box_origin[k], row.low[k], 1e-4) << row.what;
            EXPECT_NEAR(found.high[k] - test::box_origin[k], row.high[k], 1e-4) << row.what;
        }
    }
}

} // namespace
} // namespace ciel::session
