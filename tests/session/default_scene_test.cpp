#include "session/default_scene.hpp"

#include "session/scene_geometry.hpp"
#include "small_dataset/small_dataset.hpp"
#include "store/catalog.hpp"
#include "support/chosen_engine.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ciel::session {
namespace {

TEST(default_scene, shows_an_iso_surface_a_body_and_an_outline) {
    const test::Folder folder;
    test::write_small_dataset(folder.path() / "box.ciel");
    store::Catalog catalog({folder.path()});
    const auto loaded = catalog.open("box");
    const nlohmann::json document = default_scene(*loaded, "box");
    const scene::Scene scene = scene::parse(document);
    EXPECT_EQ(scene.dataset, "box");
    ASSERT_TRUE(scene.camera);
    EXPECT_EQ(document["layers"]["surface"]["groups"], nlohmann::json::array({"body"})); // not the outer side "left"
    const auto& iso = document["layers"]["iso"];
    EXPECT_EQ(iso["array"], "p");
    EXPECT_EQ(iso["color"]["array"], "U:magnitude");
    EXPECT_NEAR(iso["values"][0].get<double>(), 18, 3); // the middle of 0 .. 36

    SceneGeometry geometry(test::chosen_engine());
    const auto shown = geometry.update(scene, loaded);
    EXPECT_EQ(shown->drawables.size(), 3U);
    EXPECT_GT(shown->triangles, 100U);
}

} // namespace
} // namespace ciel::session
