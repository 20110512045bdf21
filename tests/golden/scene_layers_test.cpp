// Layers and annotations of scene documents; each scene is compared with one golden picture.
#include "frames/picture.hpp"
#include "geometry/scene_geometry.hpp"
#include "render/renderer.hpp"
#include "store/catalog.hpp"
#include "support/golden/golden.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::session {
using namespace ciel;
namespace {

using nlohmann::json;

json place(double x, double y, double z) {
    return {test::box_origin[0] + x, test::box_origin[1] + y, test::box_origin[2] + z};
}

json iso() {
    return {{"iso",
             {{"type", "iso"},
              {"array", "p"},
              {"values", {12, 20, 28}},
              {"smooth", false},
              {"edges", {{"color", "#102030"}}},
              {"color", {{"array", "U:magnitude"}, {"map", "inferno"}, {"reverse", true}}}}}};
}

json slices() {
    return {{"across",
             {{"type", "slice"},
              {"axis", "y"},
              {"value", test::box_origin[1] + 2.2},
              {"color", {{"array", "p"}, {"map", "viridis"}, {"steps", 6}}},
              {"contours", {{"array", "U:magnitude"}, {"count", 6}, {"color", "#ffffff"}}}}},
            {"free",
             {{"type", "slice"},
              {"origin", place(3, 3.4, 3)},
              {"normal", {0.3, 1, 0.5}},
              {"edges", {{"color", "#000000"}}},
              {"color",
               {{"array", "p"}, {"map", "vik"}, {"range", {10, 24}}, {"below", "#00ff00"}, {"above", "#ff00ff"}}}}}};
}

json cut_open() {
    return {{"solid",
             {{"type", "surface"},
              {"color", {{"array", "p"}, {"map", "plasma"}, {"log", true}, {"range", {1, 40}}}},
              {"edges", {{"color", "#202020"}}}}},
            {"knife", {{"type", "clip"}, {"origin", place(3, 2, 3.5)}, {"normal", {0.2, -1, 0.6}}}},
            {"box", {{"type", "outline"}}}};
}

json parts() {
    return {{"kept",
             {{"type", "surface"},
              {"threshold", {{"array", "p"}, {"range", {0, 16}}}},
              {"color", {{"array", "U:x"}, {"map", "cividis"}, {"symmetric", true}}}}},
            {"hole", {{"type", "surface"}, {"groups", {"body"}}, {"opacity", 0.5}, {"color", {{"solid", "#d06030"}}}}},
            {"bends", {{"type", "edges"}, {"angle", 30}, {"width", 3}, {"color", {{"solid", "#f0f0f0"}}}}},
            {"vertices",
             {{"type", "points"},
              {"of", "all"},
              {"size", 6},
              {"threshold", {{"array", "p"}, {"range", {24, 40}}}},
              {"color", {{"array", "p"}}}}}};
}

json lines_to_see_through() {
    return {{"skin",
             {{"type", "surface"},
              {"opacity", 0.35},
              {"color", {{"array", "p"}, {"map", "viridis"}}},
              {"edges", {{"color", "#000000"}, {"width", 3}}}}},
            {"in_it",
             {{"type", "iso"},
              {"array", "p"},
              {"values", {12}},
              {"color", {{"solid", "#c0c0c0"}}},
              {"edges", {{"color", "#400000"}}}}},
            {"bends", {{"type", "edges"}, {"angle", 30}, {"width", 5}, {"opacity", 0.6}}},
            {"box", {{"type", "outline"}, {"opacity", 0.5}}}};
}

json points_to_see_through() {
    return {{"skin", {{"type", "surface"}, {"opacity", 0.4}, {"color", {{"solid", "#a0b0c0"}}}}},
            {"in_it", {{"type", "iso"}, {"array", "p"}, {"values", {12}}, {"color", {{"solid", "#c0c0c0"}}}}},
            {"all", {{"type", "points"}, {"of", "all"}, {"size", 12}, {"opacity", 0.5}, {"color", {{"array", "p"}}}}},
            {"some",
             {{"type", "points"},
              {"size", 7},
              {"threshold", {{"array", "p"}, {"range", {20, 40}}}},
              {"color", {{"solid", "#f04020"}}}}},
            {"bends", {{"type", "edges"}, {"angle", 30}, {"width", 3}}}};
}

TEST(GoldenScenes, LayersOfADocumentLookAsTheyDid) {
    const test::Folder folder;
    test::write_small_dataset(folder.path() / "box.ciel");
    store::Catalog catalog{{folder.path()}};
    const auto loaded = catalog.open("box");
    for (const auto& [name, layers] : {std::pair{"scene_iso", iso()},
                                       {"scene_slices", slices()},
                                       {"scene_cut_open", cut_open()},
                                       {"scene_parts", parts()},
                                       {"scene_lines_to_see_through", lines_to_see_through()},
                                       {"scene_points_to_see_through", points_to_see_through()}}) {
        scene::Scene scene = scene::parse(
            {{"dataset", "box"},
             {"layers", layers},
             {"camera", {{"position", place(13, -9, 13)}, {"target", place(3, 3, 3)}, {"up", {0, 0, 1}}, {"fov", 34}}},
             {"annotations", {{"legend", true}, {"triad", true}}}});
        geometry::SceneGeometry geometry{Extraction{}};
        const scene::CheckedScene checked(std::move(scene), loaded);
        const auto shown = geometry.update(checked);
        EXPECT_TRUE(shown->lacking.empty());
        for (const render::Backend backend : render::available_backends()) {
            render::Renderer renderer(backend);
            const render::Image& image = renderer.draw(frames::picture_of(*shown, checked, {360, 270}));
            EXPECT_TRUE(test::matches_golden(name, {image.width, image.height, image.rgb}, render::name_of(backend)));
        }
    }
}

} // namespace
} // namespace server::session
