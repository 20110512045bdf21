// A slice that lies in a side of the mesh coincides with a surface layer there. The picture shows one of them, never
// parts of both.
#include "frames/picture.hpp"
#include "geometry/scene_geometry.hpp"
#include "render/renderer.hpp"
#include "store/catalog.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::geometry {
using namespace ciel;
namespace {

using nlohmann::json;

json place(double x, double y, double z) {
    return {test::box_origin[0] + x, test::box_origin[1] + y, test::box_origin[2] + z};
}

class SliceInASide : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<test::Folder>();
        test::write_small_dataset(folder->path() / "box.ciel");
    }
    static void TearDownTestSuite() { folder.reset(); }

    std::shared_ptr<const Geometry> geometry_of(const json& layers) {
        return geometry.update({scene::parse({{"dataset", "box"}, {"layers", layers}}), loaded});
    }
    // Draws the layers from a camera at (x, -3, z) that looks at the box's center, so that it sees every side
    // obliquely.
    std::vector<std::uint8_t> picture(const json& layers, double x, double z) {
        scene::Scene scene = scene::parse(
            {{"dataset", "box"},
             {"layers", layers},
             {"background", "#000000"},
             {"lighting", {{"on", false}}},
             {"annotations", {{"legend", false}, {"triad", false}}},
             {"camera", {{"position", place(x, -3, z)}, {"target", place(3, 3, 3)}, {"up", {0, 1, 0}}, {"fov", 40}}}});
        const scene::CheckedScene checked(std::move(scene), loaded);
        const auto shown = geometry.update(checked);
        return renderer.draw(frames::picture_of(*shown, checked, {240, 180})).rgb;
    }

    static std::unique_ptr<test::Folder> folder;
    store::Catalog catalog{{folder->path()}};
    std::shared_ptr<store::LoadedDataset> loaded = catalog.open("box");
    SceneGeometry geometry{Extraction{}};
    render::Renderer renderer{render::Backend::automatic};
};
std::unique_ptr<test::Folder> SliceInASide::folder;

json slice(double x, double opacity, double order) {
    return {{"type", "slice"},    {"axis", "x"},    {"value", test::box_origin[0] + x},
            {"opacity", opacity}, {"order", order}, {"color", {{"solid", "#0000ff"}}}};
}

json left(double opacity) {
    return {{"type", "surface"},
            {"groups", {"left"}},
            {"opacity", opacity},
            {"order", 1},
            {"color", {{"solid", "#ff0000"}}}};
}

TEST_F(SliceInASide, OfTwoThatAreAsTransparentTheLastIsSeen) {
    for (const double x : {0.0, -3e-6, 3e-6})
        for (const double eye : {-12.0, 14.0})
            for (const double opacity : {1.0, 0.5}) {
                const json patch = left(opacity);
                const auto last = picture({{"a", slice(x, opacity, 2)}, {"b", patch}}, eye, 6);
                EXPECT_TRUE(last == picture({{"a", slice(x, opacity, 2)}}, eye, 6))
                    << x << ' ' << eye << ' ' << opacity;
                const auto first = picture({{"a", slice(x, opacity, 0)}, {"b", patch}}, eye, 6);
                EXPECT_TRUE(first == picture({{"b", patch}}, eye, 6)) << x << ' ' << eye << ' ' << opacity;
            }
}

TEST_F(SliceInASide, WhatIsTransparentLiesOverWhatIsOpaque) {
    for (const double eye : {-12.0, 14.0})
        for (const double order : {0.0, 2.0}) {
            const auto patch = picture({{"b", left(1)}}, eye, 6);
            const auto both = picture({{"a", slice(0, 0.5, order)}, {"b", left(1)}}, eye, 6);
            for (std::size_t i = 0; i < both.size(); i += 3)
                if (patch[i] == 255) {
                    EXPECT_NEAR(both[i], 128, 1);
                    EXPECT_NEAR(both[i + 2], 128, 1);
                }
        }
}

TEST_F(SliceInASide, HidesTheWholeBoundaryThereFromEitherEnd) {
    const json solid{{"type", "surface"}, {"color", {{"solid", "#ff0000"}}}};
    for (const double z : {0.0, test::box_edge})
        for (const json& normal : {json{0, 0, 1}, json{0, 0, -1}}) {
            const json across{{"type", "slice"},
                              {"origin", place(3, 3, z)},
                              {"normal", normal},
                              {"order", 2},
                              {"color", {{"solid", "#0000ff"}}}};
            const auto alone = picture({{"a", across}}, -2, z == 0 ? -14 : 20);
            const auto both = picture({{"a", across}, {"b", solid}}, -2, z == 0 ? -14 : 20);
            const auto is_inside = [&](std::size_t i) { // false on the rim, where adjacent sides are as near
                return alone[i + 2] == 255 && alone[i - 1] == 255 && alone[i + 5] == 255;
            };
            std::size_t seen = 0;
            for (std::size_t i = 3; i + 3 < both.size(); i += 3) {
                if (!is_inside(i)) continue;
                ++seen;
                EXPECT_EQ(both[i], 0);
                EXPECT_EQ(both[i + 2], 255);
            }
            EXPECT_GT(seen, 4000U);
        }
}

TEST_F(SliceInASide, ShowsValuesEdgesAndContoursThere) {
    json across = slice(0, 1, 0);
    across["color"] = {{"array", "p"}};
    across["edges"] = json::object();
    across["contours"] = {{"array", "p"}, {"values", {9}}};
    const auto shown = geometry_of({{"a", across}});
    ASSERT_EQ(shown->drawables.size(), 3U);
    EXPECT_TRUE(shown->empty.empty());
    const auto& surface = shown->drawables[0].shape->surface;
    for (std::size_t i = 0; i < surface.positions.size(); ++i) {
        Vec3d at{};
        for (std::size_t k = 0; k < 3; ++k) at[k] = shown->origin[k] + surface.positions[i][k] - test::box_origin[k];
        EXPECT_NEAR((*shown->drawables[0].scalars)[i], test::pressure(at, 0), 1e-3);
    }
    EXPECT_FALSE(shown->drawables[2].indices().empty());
    EXPECT_TRUE(geometry_of({{"a", slice(-1e-3, 1, 0)}})->drawables.at(0).indices().empty()) << "beside the mesh";
}

// A clip plane in a side of the mesh makes no cap, because the boundary's faces are there. A cap would be a second
// layer of polygons, also in exported files.
TEST_F(SliceInASide, AClipThereNeedsNoCap) {
    const json solid{{"type", "surface"}};
    json knife{{"type", "clip"}, {"origin", place(6, 0, 0)}, {"normal", {1, 0, 0}}};
    EXPECT_EQ(geometry_of({{"a", solid}, {"b", knife}})->drawables.size(), 1U);
    knife["origin"] = place(5, 0, 0);
    EXPECT_EQ(geometry_of({{"a", solid}, {"b", knife}})->drawables.size(), 2U);
}

} // namespace
} // namespace server::geometry
