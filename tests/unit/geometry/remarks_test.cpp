// Tests the remarks of a scene: each thing that it asks for and that cannot be drawn has one.
#include "geometry/scene_geometry.hpp"
#include "store/catalog.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::geometry {
using namespace ciel;
namespace {

using nlohmann::json;
using Remarks = std::vector<std::string>;

class SceneRemarks : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<test::Folder>();
        test::write_small_dataset(folder->path() / "box.ciel");
    }
    static void TearDownTestSuite() { folder.reset(); }

    Remarks on(const json& layer, double time = 0) {
        return geometry
            .update({scene::parse({{"dataset", "box"}, {"time", time}, {"layers", {{"a", layer}}}}), loaded})
            ->remarks;
    }

    static std::unique_ptr<test::Folder> folder;
    store::Catalog catalog{{folder->path()}};
    std::shared_ptr<store::LoadedDataset> loaded = catalog.open("box");
    SceneGeometry geometry{Extraction{}};
};
std::unique_ptr<test::Folder> SceneRemarks::folder;

json slice(const json& contours) {
    return {{"type", "slice"}, {"axis", "x"}, {"value", test::box_origin[0] + 0.5}, {"contours", contours}};
}

TEST_F(SceneRemarks, SayThatNoContourLineIsThere) {
    EXPECT_EQ(on(slice({{"array", "p"}, {"values", {-3, 99}}})),
              (Remarks{"layer a has no contour lines: p takes none of the values of the lines on the layer; the data "
                       "goes from 0 to 36 at this time"}));
    EXPECT_EQ(on(slice({{"array", "p"}, {"count", 5}, {"range", {40, 50}}})).size(), 1U);
    EXPECT_EQ(on(slice({{"array", "p"}, {"values", {-3, 9}}})), Remarks{}) << "some are";
    EXPECT_EQ(on(slice({{"array", "p"}, {"values", {99}}, {"visible", false}})), Remarks{});
    json beside = slice({{"array", "p"}, {"values", {99}}});
    beside["value"] = 0;
    EXPECT_EQ(on(beside), Remarks{}) << "the layer itself is named as empty";
}

TEST_F(SceneRemarks, SayWhichStepIsShownInsteadOfTheOneAskedFor) {
    const json surface{{"type", "surface"}};
    EXPECT_EQ(on(surface, 1.25), (Remarks{"there is no step at time 1.25; the nearest, 1, is shown"}));
    EXPECT_EQ(on(surface, -7), (Remarks{"there is no step at time −7; the nearest, 0, is shown"}));
    for (const double time : {0.0, 1.0, 2.0, 2 + 1e-9}) EXPECT_EQ(on(surface, time), Remarks{}) << time;
}

TEST_F(SceneRemarks, SayThatAnOutlineHasNoColorsOfAnArray) {
    EXPECT_EQ(on({{"type", "outline"}, {"color", {{"array", "p"}}}}),
              (Remarks{"layer a has no colors of p: an outline is a box without values; leave color.array out of the "
                       "layer, or color another layer by the array"}));
    EXPECT_EQ(on({{"type", "outline"}, {"color", {{"solid", "#ff0000"}}}}), Remarks{});
}

} // namespace
} // namespace server::geometry
