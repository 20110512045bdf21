// Scene document with two iso-surfaces of 50 % opacity, a volume and an opaque slice, from six sides in one picture.
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

constexpr std::size_t width = 240, height = 180, columns = 3, rows = 2;

struct Look {
    std::array<double, 3> from, up;
};

constexpr std::array<Look, columns * rows> looks{{{{1, 0.35, 0.3}, {0, 0, 1}},
                                                  {{-1, 0.35, 0.3}, {0, 0, 1}},
                                                  {{0.35, 1, 0.3}, {0, 0, 1}},
                                                  {{0.35, -1, 0.3}, {0, 0, 1}},
                                                  {{0.3, 0.35, 1}, {0, 1, 0}},
                                                  {{0.3, 0.35, -1}, {0, 1, 0}}}};

json place(double x, double y, double z) {
    return {test::box_origin[0] + x, test::box_origin[1] + y, test::box_origin[2] + z};
}

json scene_from(const Look& look) {
    const auto [x, y, z] = look.from;
    return {
        {"dataset", "box"},
        {"annotations", {{"legend", false}, {"triad", false}}},
        {"layers",
         {{"low",
           {{"type", "iso"}, {"array", "p"}, {"values", {12}}, {"opacity", 0.5}, {"color", {{"solid", "#e08030"}}}}},
          {"high",
           {{"type", "iso"}, {"array", "p"}, {"values", {24}}, {"opacity", 0.5}, {"color", {{"solid", "#3090e0"}}}}},
          {"across",
           {{"type", "slice"},
            {"origin", place(3, 3, 2.2)},
            {"normal", {0, 0, 1}},
            {"color", {{"array", "p"}, {"map", "grayscale"}}}}},
          {"fog",
           {{"type", "volume"},
            {"array", "p"},
            {"color", {{"array", "p"}, {"map", "viridis"}}},
            {"opacity_points", {{0, 0.02}, {0.5, 0.25}, {1, 0.1}}}}}}},
        {"camera",
         {{"position", place(3 + 17 * x, 3 + 17 * y, 3 + 17 * z)},
          {"target", place(3, 3, 3)},
          {"up", look.up},
          {"fov", 30}}}};
}

TEST(GoldenScenes, LayersOfADocumentLookRightFromSixSides) {
    const test::Folder folder;
    test::write_small_dataset(folder.path() / "box.ciel");
    store::Catalog catalog{{folder.path()}};
    const auto loaded = catalog.open("box");
    geometry::SceneGeometry geometry{Extraction{}};
    for (const render::Backend backend : render::available_backends()) {
        render::Renderer renderer(backend);
        test::Picture all{columns * width, rows * height, {}};
        all.rgb.resize(std::size_t{3} * columns * width * rows * height);
        for (std::size_t i = 0; i < looks.size(); ++i) {
            const scene::CheckedScene checked(scene::parse(scene_from(looks[i])), loaded);
            const auto shown = geometry.update(checked);
            ASSERT_TRUE(shown->lacking.empty());
            const render::Image& image = renderer.draw(frames::picture_of(*shown, checked, {width, height}));
            for (std::size_t row = 0; row < height; ++row) {
                const std::size_t at = (i / columns * height + row) * columns * width + i % columns * width;
                std::copy_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * row * width), 3 * width,
                            all.rgb.begin() + static_cast<std::ptrdiff_t>(3 * at));
            }
        }
        EXPECT_TRUE(test::matches_golden("scene_from_six_sides", all, render::name_of(backend)));
    }
}

} // namespace
} // namespace server::session
