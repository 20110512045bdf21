// The drawables made from layers of every kind, on the box of tests/support/small_dataset.
#include "frames/batches.hpp"
#include "geometry/scene_geometry.hpp"
#include "store/catalog.hpp"
#include "support/chosen_algorithm.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace server::geometry {
using namespace ciel;
namespace {

using nlohmann::json;

class layers : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<test::Folder>();
        test::write_small_dataset(folder->path() / "box.ciel");
    }
    static void TearDownTestSuite() { folder.reset(); }

    std::shared_ptr<const Geometry> show(const json& all) {
        return geometry.update({scene::parse({{"dataset", "box"}, {"layers", all}}), loaded});
    }

    static std::unique_ptr<test::Folder> folder;
    store::Catalog catalog{{folder->path()}};
    std::shared_ptr<store::LoadedDataset> loaded = catalog.open("box");
    SceneGeometry geometry{test::chosen_algorithm()};
};
std::unique_ptr<test::Folder> layers::folder;

json iso(double value) { return {{"type", "iso"}, {"array", "p"}, {"values", {value}}}; }
json slice(double x) { return {{"type", "slice"}, {"axis", "x"}, {"value", test::box_origin[0] + x}}; }

double length(const Drawable& lines) {
    const auto& at = lines.shape->surface.positions;
    const auto indices = lines.indices();
    double sum = 0;
    for (std::size_t i = 0; i + 1 < indices.size(); i += 2) {
        const Vec3f &a = at[indices[i]], &b = at[indices[i + 1]];
        sum += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    return sum;
}

TEST_F(layers, edges_follow_their_surface_and_share_its_points) {
    for (json layer : {iso(20), slice(2.5), json{{"type", "surface"}}}) {
        layer["opacity"] = 0.5;
        EXPECT_EQ(show({{"a", layer}})->drawables.size(), 1U);
        layer["edges"] = {{"color", "#ff0000"}, {"width", 3}};
        const auto shown = show({{"a", layer}});
        ASSERT_EQ(shown->drawables.size(), 2U) << layer;
        const Drawable& surface = shown->drawables[0];
        const Drawable& edges = shown->drawables[1];
        EXPECT_FALSE(surface.lines());
        ASSERT_TRUE(edges.lines());
        EXPECT_EQ(edges.shape, surface.shape);
        EXPECT_EQ(edges.color, (std::array<float, 4>{1, 0, 0, 0.5F}));
        EXPECT_EQ(edges.line_width, 3);
        EXPECT_NE(edges.identity, surface.identity);
        EXPECT_EQ(show({{"a", layer}})->drawables[1].revision, edges.revision) << "nothing has changed";
        layer["edges"]["visible"] = false;
        EXPECT_EQ(show({{"a", layer}})->drawables.size(), 1U);
    }
}

// Edges are the sides of polygons, without the diagonals of their triangles.
TEST_F(layers, edges_hold_the_sides_of_polygons_only) {
    json layer{{"type", "surface"}, {"edges", json::object()}};
    const auto shown = show({{"a", layer}});
    const Surface& surface = shown->drawables[0].shape->surface;
    std::set<std::pair<Index, Index>> sides;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i)
        for (Index k = surface.polygon_offset[i]; k < surface.polygon_offset[i + 1]; ++k) {
            const Index next = k + 1 < surface.polygon_offset[i + 1] ? k + 1 : surface.polygon_offset[i];
            sides.insert(std::minmax(surface.polygon_vertex[k], surface.polygon_vertex[next]));
        }
    EXPECT_EQ(shown->drawables[1].indices().size(), 2 * sides.size());
    EXPECT_LT(sides.size(), shown->triangles * 3 / 2) << "fewer than the triangles have";
    EXPECT_GT(length(shown->drawables[1]), 0);
}

TEST_F(layers, edges_are_counted_and_given_back) {
    json layer = slice(2.5);
    show({{"a", layer}});
    const std::size_t without = geometry.memory_bytes();
    layer["edges"] = json::object();
    const auto shown = show({{"a", layer}});
    EXPECT_EQ(geometry.memory_bytes(), without + shown->drawables[1].indices().size_bytes());
    layer["edges"] = nullptr;
    layer.erase("edges");
    show({{"a", layer}});
    EXPECT_EQ(geometry.memory_bytes(), without);
}

// On the plane x = 0.5 of the box, p = 0.5 + 2 y + 3 z, so contour lines are straight and have a known length.
TEST_F(layers, contour_lines_lie_where_the_array_has_the_values) {
    json layer = slice(0.5); // in front of the hole
    layer["contours"] = {{"array", "p"}, {"values", {6.5, 12.5, 1e6}}, {"width", 4}, {"color", "#00ff00"}};
    layer["opacity"] = 0.25;
    const auto shown = show({{"a", layer}});
    ASSERT_EQ(shown->drawables.size(), 2U);
    const Drawable& lines = shown->drawables[1];
    ASSERT_TRUE(lines.lines());
    EXPECT_EQ(lines.color, (std::array<float, 4>{0, 1, 0, 0.25F}));
    EXPECT_EQ(lines.line_width, 4);
    std::size_t at_low = 0;
    for (const Vec3f& position : lines.shape->surface.positions) {
        const Vec3d at = test::in_box(shown->origin, position);
        const double p = test::pressure(at, 0);
        EXPECT_NEAR(at[0], 0.5, 1e-5);
        EXPECT_NEAR(std::min(std::abs(p - 6.5), std::abs(p - 12.5)), 0, 1e-4);
        at_low += std::abs(p - 6.5) < 1e-4 ? 1U : 0U;
    }
    EXPECT_GT(at_low, 0U);
    // The line of p = 6.5 goes from (y, z) = (3, 0) to (0, 2), that of p = 12.5 from (6, 0) to (0, 4).
    EXPECT_NEAR(length(lines), std::hypot(3, 2) + std::hypot(6, 4), 1e-4);
    EXPECT_EQ(show({{"a", layer}})->drawables[1].revision, lines.revision) << "nothing has changed";
    layer["value"] = test::box_origin[0] + 1;
    EXPECT_NE(show({{"a", layer}})->drawables[1].revision, lines.revision) << "the slice has moved";
    layer["contours"]["visible"] = false;
    EXPECT_EQ(show({{"a", layer}})->drawables.size(), 1U);
}

TEST_F(layers, a_count_of_contour_lines_is_spread_evenly_inside_the_range) {
    json layer = slice(0.5);
    layer["contours"] = {{"array", "U:x"}, {"count", 2}}; // U:x equals z, which goes from 0 to 6
    const auto heights = [&] {
        const auto shown = show({{"a", layer}});
        std::set<long> found;
        for (const Vec3f& position : shown->drawables.at(1).shape->surface.positions)
            found.insert(std::lround(1000 * test::in_box(shown->origin, position)[2]));
        return found;
    };
    EXPECT_EQ(heights(), (std::set<long>{2000, 4000}));
    layer["contours"]["range"] = {0, 1.5};
    EXPECT_EQ(heights(), (std::set<long>{500, 1000}));
}

TEST_F(layers, contour_lines_of_an_array_that_was_not_written_are_lacking) {
    json layer = slice(0.5);
    layer["contours"] = {{"array", "late"}};
    const auto shown = show({{"a", layer}});
    EXPECT_EQ(shown->drawables.size(), 1U);
    ASSERT_EQ(shown->lacking.size(), 1U);
    EXPECT_EQ(shown->lacking[0], "layer a has no contour lines: 'late' has no values at time 0; it has values at 2");
}

TEST_F(layers, names_in_layers_are_checked_with_their_path) {
    const struct {
        json layer;
        const char* path;
    } rows[] = {
        {{{"type", "slice"}, {"axis", "x"}, {"value", 1}, {"contours", {{"array", "nope"}}}},
         "/layers/a/contours/array"},
        {{{"type", "slice"}, {"axis", "x"}, {"value", 1}, {"contours", {{"array", "cell:q"}}}},
         "/layers/a/contours/array"},
        {{{"type", "surface"}, {"threshold", {{"array", "nope"}, {"range", {0, 1}}}}}, "/layers/a/threshold/array"},
        {{{"type", "edges"}, {"groups", {"nope"}}}, "/layers/a/groups/0"},
        {{{"type", "edges"}, {"color", {{"array", "cell:q"}}}}, "/layers/a/color/array"},
        {{{"type", "points"}, {"color", {{"array", "cell:q"}}}}, "/layers/a/color/array"},
        {{{"type", "volume"}, {"array", "cell:q"}}, "/layers/a/array"},
        {{{"type", "points"}, {"color", {{"array", "nope"}}}}, "/layers/a/color/array"}};
    for (const auto& row : rows) {
        try {
            show({{"a", row.layer}});
            ADD_FAILURE() << row.layer << " was accepted";
        } catch (const scene::Invalid& error) {
            EXPECT_EQ(error.path, row.path) << error.what();
        }
    }
}

TEST_F(layers, a_change_of_the_edges_alone_is_new_content) {
    json layer = slice(2.5);
    layer["edges"] = {{"width", 1}};
    const auto thin = frames::content_of(*show({{"a", layer}}));
    layer["edges"] = {{"width", 2}};
    const auto wide = frames::content_of(*show({{"a", layer}}));
    layer["edges"] = {{"width", 2}, {"color", "#ff0000"}};
    const auto red = frames::content_of(*show({{"a", layer}}));
    EXPECT_EQ((std::set{thin, wide, red}).size(), 3U);
}

} // namespace
} // namespace server::geometry
