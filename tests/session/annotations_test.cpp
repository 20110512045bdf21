// From a scene to what is written over its picture.
#include "session/annotations.hpp"

#include "session/picture.hpp"
#include "small_dataset/small_dataset.hpp"
#include "store/catalog.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ciel::session {
namespace {

using nlohmann::json;

class SceneAnnotations : public testing::Test {
protected:
    SceneAnnotations() { test::write_small_dataset(folder / "box.ciel"); }

    render::Annotations of(const json& layers, const json& annotations = json::object(), double time = 0) {
        scene = scene::parse({{"dataset", "box"}, {"time", time}, {"layers", layers}, {"annotations", annotations}});
        shown = geometry.update(scene, catalog.open("box"));
        return annotations_of(*shown, scene);
    }
    static json surface(const json& color) { return {{"type", "surface"}, {"color", color}}; }

    test::Folder folder;
    store::Catalog catalog{{folder.path()}};
    SceneGeometry geometry{Engine::signatures};
    scene::Scene scene;
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
    EXPECT_EQ(written.legends[2].scale.range, (std::array<float, 2>{1, 2}));
    EXPECT_EQ(written.legends[3].name, "U:x");
    for (const render::Legend& legend : written.legends)
        EXPECT_EQ(legend.units, catalog.open("box")->dataset()->find(legend.name.substr(0, 1))->units);
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

TEST_F(SceneAnnotations, AreOnPicturesAndNotOnFrames) {
    static_cast<void>(of({{"a", surface({{"array", "p"}})}}));
    EXPECT_FALSE(picture_of(*shown, scene, {320, 200}).annotations.empty());
    EXPECT_TRUE(frame_of(*shown, scene, 320, 200, 4).annotations.empty());
}

} // namespace
} // namespace ciel::session
