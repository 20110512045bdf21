// The annotations that a scene's picture gets: legends, captions, axes.
#include "geometry/scene_annotations.hpp"

#include "frames/frame_of.hpp"
#include "frames/picture.hpp"
#include "geometry/viewpoint.hpp"
#include "store/catalog.hpp"
#include "support/chosen_algorithm.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::geometry {
using namespace ciel;
namespace {

using nlohmann::json;

class SceneAnnotations : public testing::Test {
protected:
    SceneAnnotations() { test::write_small_dataset(folder / "box.ciel"); }

    annotations::Annotations of(const json& layers, const json& annotations = json::object(), double time = 0) {
        checked.emplace(
            scene::parse({{"dataset", "box"}, {"time", time}, {"layers", layers}, {"annotations", annotations}}),
            catalog.open("box"));
        shown = geometry.update(*checked);
        return annotations_of(*shown, *checked);
    }
    static json surface(const json& color) { return {{"type", "surface"}, {"color", color}}; }

    test::Folder folder;
    store::Catalog catalog{{folder.path()}};
    SceneGeometry geometry{test::chosen_algorithm()};
    std::optional<scene::CheckedScene> checked;
    std::shared_ptr<const Geometry> shown;
};

TEST_F(SceneAnnotations, HaveOneLegendForEachArrayMapAndRange) {
    const auto written = of({{"a", surface({{"array", "p"}})},
                             {"b", surface({{"array", "p"}})},
                             {"c", surface({{"array", "p"}, {"map", "magma"}})},
                             {"d", surface({{"array", "p"}, {"range", {1, 2}}})},
                             {"e", surface({{"array", "U:x"}})},
                             {"f", surface({{"solid", "#ff0000"}})},
                             {"g", {{"type", "surface"}, {"visible", false}, {"color", {{"array", "U:y"}}}}}});
    ASSERT_EQ(written.legends.size(), 4U);
    EXPECT_EQ(written.legends[0].name, "p");
    EXPECT_EQ(written.legends[0].scale.map, "viridis");
    EXPECT_EQ(written.legends[1].scale.map, "magma");
    EXPECT_EQ(written.legends[2].scale.range, (std::array<double, 2>{1, 2}));
    EXPECT_EQ(written.legends[3].name, "U:x");
}

TEST_F(SceneAnnotations, TellApartLegendsOfOneArrayByTheirLayers) {
    const json document = json::parse(std::ifstream(CIEL_SOURCE_DIR "/tests/support/legend_cases.json"));
    for (const json& row : document["cases"]) {
        json shown_legends = json::array();
        for (const annotations::Legend& legend : of(row["layers"]).legends)
            shown_legends.push_back({legend.name, legend.layers});
        EXPECT_EQ(shown_legends, row["legends"]) << row["what"];
    }
}

TEST_F(SceneAnnotations, HaveTheUnitsOfTheArrayThatAScalarIsMadeFrom) {
    const json volume{{"type", "volume"}, {"array", "U:magnitude"}};
    const auto written =
        of({{"a", surface({{"array", "p"}})}, {"b", surface({{"array", "U:x"}})}, {"c", volume}}, {{"axes", true}});
    std::map<std::string, std::string> units;
    for (const annotations::Legend& legend : written.legends) units[legend.name] = legend.units;
    EXPECT_EQ(units, (std::map<std::string, std::string>{{"p", "Pa"}, {"U:x", "m/s"}, {"U:magnitude", "m/s"}}));
    EXPECT_EQ(written.length_units, "m");
}

TEST_F(SceneAnnotations, AreLegendAndTriadWhereNothingIsSaid) {
    const auto written = of({{"a", surface({{"array", "p"}})}});
    EXPECT_EQ(written.legends.size(), 1U);
    EXPECT_TRUE(written.triad);
    EXPECT_FALSE(written.axes);
    EXPECT_TRUE(written.captions.empty());
    EXPECT_TRUE(written.title.empty());
}

TEST_F(SceneAnnotations, AreSwitched) {
    const auto written = of({{"a", surface({{"array", "p"}})}},
                            {{"legend", false},
                             {"triad", false},
                             {"axes", true},
                             {"time", true},
                             {"dataset", true},
                             {"title", "µ"},
                             {"scale", 2}},
                            1);
    EXPECT_TRUE(written.legends.empty());
    EXPECT_FALSE(written.triad);
    EXPECT_TRUE(written.axes);
    EXPECT_EQ(written.captions, (std::vector<std::string>{"box", "Time: 1"}));
    EXPECT_EQ(written.title, "µ");
    EXPECT_EQ(written.scale, 2);
}

TEST_F(SceneAnnotations, MakeRoomForThemselvesInPicturesAndFramesAlike) {
    static_cast<void>(of({{"a", surface({{"array", "p"}})}}, {{"axes", true}}));
    const auto picture = frames::picture_of(*shown, *checked, {320, 200}).camera;
    const auto bare = camera_of(*shown, checked->scene().camera, 1.6);
    const auto away = [](const annotations::ViewCamera& camera) {
        return std::hypot(camera.position[0] - camera.target[0], camera.position[1] - camera.target[1],
                          camera.position[2] - camera.target[2]);
    };
    EXPECT_GT(away(picture), 1.05 * away(bare)) << "else the legend lies on the box";
    EXPECT_EQ(picture.position, frames::frame_of(*shown, *checked, 320, 200, 1).camera.position)
        << "a pixel of the one is probed in the other";
    const scene::Camera given{{9, 8, 7}, {0, 0, 0}, {0, 0, 1}, 30, false, 1};
    EXPECT_EQ(frames::picture_of(*shown, checked->with_camera(given), {320, 200}).camera.position, given.position);
}

TEST_F(SceneAnnotations, AreOnPicturesAndNotOnFrames) {
    static_cast<void>(of({{"a", surface({{"array", "p"}})}}));
    EXPECT_FALSE(frames::picture_of(*shown, *checked, {320, 200}).annotations.empty());
    EXPECT_TRUE(frames::frame_of(*shown, *checked, 320, 200, 4).annotations.empty());
}

} // namespace
} // namespace server::geometry
