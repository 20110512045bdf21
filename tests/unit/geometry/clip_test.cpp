// Clips, thresholds, edges and points of the box of tests/support/small_dataset, from the scene to what is drawn and
// sent.
#include "geometry/clip.hpp"

#include "frames/batches.hpp"
#include "frames/frame_of.hpp"
#include "limits/errors.hpp"
#include "store/catalog.hpp"
#include "support/chosen_algorithm.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace server::geometry {
using namespace ciel;
namespace {

using nlohmann::json;

class cells : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<test::Folder>();
        test::write_small_dataset(folder->path() / "box.ciel");
    }
    static void TearDownTestSuite() { folder.reset(); }

    std::shared_ptr<const Geometry> show(const json& layers) {
        checked.emplace(scene::parse({{"dataset", "box"}, {"layers", layers}}), loaded);
        return geometry.update(*checked);
    }

    static std::unique_ptr<test::Folder> folder;
    store::Catalog catalog{{folder->path()}};
    std::shared_ptr<store::LoadedDataset> loaded = catalog.open("box");
    SceneGeometry geometry{test::chosen_algorithm()};
    std::optional<scene::CheckedScene> checked;
};
std::unique_ptr<test::Folder> cells::folder;

json clip_x(double x) { return {{"type", "clip"}, {"axis", "x"}, {"value", test::box_origin[0] + x}}; }
json threshold(double low, double high) { return {{"array", "U:x"}, {"range", {low, high}}}; } // U:x equals z
const json surface{{"type", "surface"}, {"order", 1}};

// Returns the volume that all drawables enclose together after the clip planes have cut them.
double enclosed(const Geometry& shown) {
    double six = 0;
    for (const Drawable& drawable : shown.drawables) {
        if (!drawable.polygons()) continue;
        const Surface cut = clipped(shown, drawable).surface;
        for (std::size_t i = 0; i < cut.polygon_cell.size(); ++i)
            for (Index k = cut.polygon_offset[i] + 2; k < cut.polygon_offset[i + 1]; ++k) {
                const Vec3f &a = cut.positions[cut.polygon_vertex[cut.polygon_offset[i]]],
                            &b = cut.positions[cut.polygon_vertex[k - 1]], &c = cut.positions[cut.polygon_vertex[k]];
                six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0]);
            }
    }
    return six / 6;
}

TEST_F(cells, a_clip_and_its_caps_leave_the_solid_that_is_kept) {
    EXPECT_NEAR(enclosed(*show({{"s", surface}})), 216 - 8, 1e-3);
    EXPECT_NEAR(enclosed(*show({{"s", surface}, {"c", clip_x(3)}})), 3 * 36 - 4, 1e-2);
    json other = clip_x(0.5);
    other["invert"] = true;
    EXPECT_NEAR(enclosed(*show({{"s", surface}, {"c", other}})), 5.5 * 36 - 8, 1e-2);
    EXPECT_NEAR(enclosed(*show({{"s", surface}, {"c", clip_x(3.5)}, {"d", other}})), 3 * 36 - 1.5 * 4, 1e-2);
    const json oblique{{"type", "clip"}, {"origin", {1003, 3, -47}}, {"normal", {3, 3, 3}}};
    EXPECT_NEAR(enclosed(*show({{"s", surface}, {"c", oblique}})), (216 - 8) / 2, 1e-2) << "through the middle";
    EXPECT_EQ(show({{"s", surface}, {"c", clip_x(7)}})->drawables[1].indices().size(), 0U) << "nothing is cut";
}

TEST_F(cells, caps_look_like_their_surface_and_patches_have_none) {
    json colored = surface;
    colored["color"] = {{"array", "p"}, {"map", "inferno"}};
    colored["opacity"] = 0.5;
    colored["edges"] = json::object();
    const auto shown = show({{"s", colored}, {"c", clip_x(3)}});
    ASSERT_EQ(shown->drawables.size(), 4U) << "surface, edges, cap, its edges";
    const Drawable& cap = shown->drawables[2];
    EXPECT_EQ(cap.layer, "s");
    EXPECT_EQ(cap.scale.map, "inferno");
    EXPECT_EQ(cap.color, shown->drawables[0].color);
    EXPECT_TRUE(shown->drawables[3].lines());
    const auto& at = cap.shape->surface.positions;
    ASSERT_FALSE(at.empty());
    for (std::size_t i = 0; i < at.size(); ++i) {
        const Vec3d place = test::in_box(shown->origin, at[i]);
        EXPECT_NEAR(place[0], 3, 1e-5);
        EXPECT_NEAR((*cap.scalars)[i], test::pressure(place, 0), 1e-3);
    }
    json open = clip_x(3);
    open["caps"] = false;
    EXPECT_EQ(show({{"s", surface}, {"c", open}})->drawables.size(), 1U);
    json patch = surface;
    patch["groups"] = {"left"};
    EXPECT_EQ(show({{"s", patch}, {"c", clip_x(3)}})->drawables.size(), 1U);
    json off = clip_x(3);
    off["visible"] = false;
    EXPECT_TRUE(show({{"s", surface}, {"c", off}})->clip.empty());
}

TEST_F(cells, a_moved_clip_is_in_frames_and_in_messages) {
    const auto first = show({{"s", surface}, {"c", clip_x(3)}});
    const render::Frame frame = frames::frame_of(*first, *checked, 320, 200, 1);
    ASSERT_EQ(frame.clip.size(), 1U);
    EXPECT_EQ(frame.clip[0][0], -1);
    const double plane = test::box_origin[0] + 3 - first->origin[0];
    EXPECT_GT(frame.clip[0][3], plane) << "by the slack";
    EXPECT_NEAR(frame.clip[0][3], plane, 1e-3);
    wire::FrameHeader header;
    const auto messages = frames::geometry_messages(header, *first, 1, 1.0 / 1024, {}).payloads;
    const std::string text(messages.at(0).begin(), messages.at(0).end());
    EXPECT_THAT(text, testing::HasSubstr("\"clip\": [[-1, "));
    json only_open = clip_x(3);
    only_open["caps"] = false;
    const auto key = frames::content_of(*show({{"s", surface}, {"c", only_open}}));
    only_open["value"] = 1003.5;
    EXPECT_NE(frames::content_of(*show({{"s", surface}, {"c", only_open}})), key);
}

TEST_F(cells, what_is_no_longer_shown_of_a_clip_is_given_back) {
    show({{"s", surface}});
    const std::size_t without = geometry.memory_bytes();
    show({{"s", surface}, {"c", clip_x(3)}, {"d", clip_x(4)}});
    EXPECT_GT(geometry.memory_bytes(), without);
    show({{"s", surface}});
    EXPECT_EQ(geometry.memory_bytes(), without);
}

// U:x equals z. The lattice's vertices have integer z, so a range of U:x keeps whole layers of cells.
TEST_F(cells, a_threshold_shows_the_boundary_of_the_cells_kept) {
    json layer = surface;
    layer["threshold"] = threshold(0, 1.25); // less than the z of the pyramids' tips in the next layer
    EXPECT_NEAR(enclosed(*show({{"s", layer}})), 36, 1e-3) << "the lowest layer";
    layer["threshold"]["keep"] = "any";
    EXPECT_NEAR(enclosed(*show({{"s", layer}})), 2 * 36, 6) << "and those above that touch it";
    layer["threshold"] = threshold(2, 4);
    EXPECT_NEAR(enclosed(*show({{"s", layer}})), 2 * 36 - 8, 1e-3) << "around the hole";
    EXPECT_NEAR(enclosed(*show({{"s", layer}, {"c", clip_x(3)}})), (2 * 36 - 8) / 2.0, 1e-2) << "caps of these cells";
    layer["threshold"]["enabled"] = false;
    EXPECT_NEAR(enclosed(*show({{"s", layer}})), 216 - 8, 1e-3);
    layer["threshold"] = threshold(50, 60);
    EXPECT_EQ(show({{"s", layer}})->triangles, 0U);
    layer["threshold"] = {{"array", "late"}, {"range", {0, 1}}};
    const auto lacking = show({{"s", layer}});
    EXPECT_TRUE(lacking->drawables.empty());
    EXPECT_THAT(lacking->lacking.at(0), testing::StartsWith("layer s is not shown: 'late' has no values at time 0"));
}

TEST_F(cells, a_threshold_by_an_array_of_the_cells_asks_no_vertices) {
    json layer = surface;
    layer["threshold"] = {{"array", "cell:q"}, {"range", {0, 1e6}}, {"keep", "any"}}; // cell:q is the cell's id
    EXPECT_NEAR(enclosed(*show({{"s", layer}})), 216 - 8, 1e-3);
    layer["threshold"]["range"] = {7, 9};
    const auto some = show({{"s", layer}});
    const auto values = loaded->stored_scalar("cell:q", 0, store::Association::cell)->all();
    std::set<double> kept;
    for (const Index cell : some->drawables.at(0).shape->surface.polygon_cell) kept.insert(values[cell]);
    EXPECT_THAT(kept, testing::ElementsAre(7, 8, 9));
}

double length(const Drawable& lines) {
    const auto& at = lines.shape->surface.positions;
    double sum = 0;
    for (std::size_t i = 0; i + 1 < lines.indices().size(); i += 2) {
        const Vec3f &a = at[lines.indices()[i]], &b = at[lines.indices()[i + 1]];
        sum += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    return sum;
}

TEST_F(cells, edges_of_the_mesh_are_all_or_those_that_bend) {
    const json edges{{"type", "edges"}, {"angle", 30}, {"width", 3}, {"color", {{"array", "p"}}}};
    const auto shown = show({{"e", edges}});
    ASSERT_EQ(shown->drawables.size(), 1U);
    const Drawable& features = shown->drawables[0];
    EXPECT_TRUE(features.lines());
    EXPECT_EQ(features.line_width, 3);
    EXPECT_TRUE(features.scalars);
    EXPECT_NEAR(length(features), 12 * 6 + 12 * 2, 1e-3) << "of the box and of its hole";
    json part = edges;
    part["threshold"] = threshold(0, 1);
    EXPECT_NEAR(length(show({{"e", part}})->drawables[0]), 8 * 6 + 4, 1e-3) << "of the lowest layer";
    json all = edges;
    all.erase("angle");
    EXPECT_GT(length(show({{"e", all}})->drawables[0]), 6 * 6 * 10);
}

TEST_F(cells, points_are_those_of_the_boundary_or_all_and_thinning_is_said) {
    json points{{"type", "points"}, {"size", 7}};
    const auto shown = show({{"p", points}});
    ASSERT_EQ(shown->drawables.size(), 1U);
    EXPECT_TRUE(shown->drawables[0].points());
    EXPECT_EQ(shown->drawables[0].line_width, 7);
    for (const Vec3f& position : shown->drawables[0].shape->surface.positions) {
        const auto on = [&](double low, double high) {
            for (const double x : test::in_box(shown->origin, position))
                if (std::abs(x - low) < 1e-5 || std::abs(x - high) < 1e-5) return true;
            return false;
        };
        EXPECT_TRUE(on(0, 6) || on(2, 4));
    }
    points["of"] = "all";
    const auto all = show({{"p", points}});
    EXPECT_EQ(all->drawables[0].indices().size(), loaded->dataset()->info().meshes[0].vertices);
    EXPECT_TRUE(all->remarks.empty());
    points["most"] = 100;
    const auto few = show({{"p", points}});
    EXPECT_LE(few->drawables[0].indices().size(), 100U);
    EXPECT_GT(few->drawables[0].indices().size(), 50U);
    ASSERT_EQ(few->remarks.size(), 1U);
    EXPECT_THAT(few->remarks[0],
                testing::AllOf(testing::HasSubstr("layer p shows one in "),
                               testing::HasSubstr(std::to_string(all->drawables[0].indices().size()))));
    EXPECT_NO_THROW(require_complete(*few)) << "a picture of fewer points is a picture";
    points.erase("most");
    points["threshold"] = threshold(0, 1);
    for (const Vec3f& at : show({{"p", points}})->drawables[0].shape->surface.positions) EXPECT_LE(at[2], 1.00001F);
}

} // namespace
} // namespace server::geometry
