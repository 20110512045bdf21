#include "geometry/scene_geometry.hpp"

#include "frames/frame_of.hpp"
#include "limits/errors.hpp"
#include "store/catalog.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::geometry {
using namespace ciel;
namespace {

using nlohmann::json;

class scene_geometry : public testing::TestWithParam<Algorithm> {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<test::Folder>();
        test::write_small_dataset(folder->path() / "box.ciel");
    }
    static void TearDownTestSuite() { folder.reset(); }

    std::shared_ptr<const Geometry> show(const json& document) {
        return geometry.update({scene::parse(document), loaded});
    }
    static json scene_of(json layers) { return {{"dataset", "box"}, {"layers", std::move(layers)}}; }

    static std::unique_ptr<test::Folder> folder;
    store::Catalog catalog{{folder->path()}};
    std::shared_ptr<store::LoadedDataset> loaded = catalog.open("box");
    SceneGeometry geometry{GetParam()};
};
std::unique_ptr<test::Folder> scene_geometry::folder;

double area(const Drawable& drawable) {
    const Shape& shape = *drawable.shape;
    double sum = 0;
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        std::array<Vec3d, 2> side{};
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t axis = 0; axis < 3; ++axis)
                side[k][axis] = shape.surface.positions[shape.indices[i + k + 1]][axis] -
                                shape.surface.positions[shape.indices[i]][axis];
        sum += std::hypot(side[0][1] * side[1][2] - side[0][2] * side[1][1],
                          side[0][2] * side[1][0] - side[0][0] * side[1][2],
                          side[0][0] * side[1][1] - side[0][1] * side[1][0]) /
               2;
    }
    return sum;
}

json iso(std::vector<double> values) { return {{"type", "iso"}, {"array", "p"}, {"values", std::move(values)}}; }
json slice(double x) { return {{"type", "slice"}, {"axis", "x"}, {"value", test::box_origin[0] + x}}; }

TEST_P(scene_geometry, areas_are_those_of_the_box) {
    const auto shown = show(scene_of({{"a", {{"type", "surface"}, {"order", 1}}},
                                      {"b", {{"type", "surface"}, {"order", 2}, {"groups", {"left"}}}},
                                      {"c", {{"type", "surface"}, {"order", 3}, {"groups", {"left", "body"}}}},
                                      {"d", {{"type", "slice"}, {"order", 4}, {"axis", "x"}, {"value", 1000.5}}},
                                      {"e", {{"type", "slice"}, {"order", 5}, {"axis", "x"}, {"value", 1003.25}}}}));
    ASSERT_EQ(shown->drawables.size(), 5U);
    EXPECT_NEAR(area(shown->drawables[0]), 6 * 36 + 6 * 4, 1e-3); // the box of edge 6 and its hole of edge 2
    EXPECT_NEAR(area(shown->drawables[1]), 36, 1e-4);
    EXPECT_NEAR(area(shown->drawables[2]), 36 + 24, 1e-4);
    EXPECT_NEAR(area(shown->drawables[3]), 36, 1e-4);
    EXPECT_NEAR(area(shown->drawables[4]), 36 - 4, 1e-4);
}

TEST_P(scene_geometry, iso_surface_has_the_value_and_the_interpolated_colors) {
    json layer = iso({7.5});
    layer["color"] = {{"array", "U:x"}};
    json document = scene_of({{"i", layer}});
    for (const double time : {0.0, 1.0, 0.0}) {
        document["time"] = time;
        const auto shown = show(document);
        const Drawable& drawable = shown->drawables.at(0);
        const auto& positions = drawable.shape->surface.positions;
        ASSERT_EQ(time == 1, positions.empty()); // at time 1, p is at least 10 everywhere
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Vec3d at = test::in_box(shown->origin, positions[i]);
            EXPECT_NEAR(test::pressure(at, time), 7.5, 1e-4);
            EXPECT_NEAR((*drawable.scalars)[i], test::velocity(at)[0], 1e-4);
        }
        EXPECT_EQ(drawable.scale.range, (std::array<double, 2>{0, 6}));
    }
}

// Interpolating the surface's own array gives its iso-value only up to rounding. If the value is a bound between two
// color steps, the surface would show specks of both colors.
TEST_P(scene_geometry, iso_surfaces_colored_by_their_own_array_have_one_color_each) {
    json layer = iso({7.1, 11.3, 13.7});
    layer["color"] = {{"array", "p"}, {"steps", 4}};
    const auto shown = show(scene_of({{"i", layer}}));
    ASSERT_EQ(shown->drawables.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const float value = layer["values"][i];
        ASSERT_FALSE(shown->drawables[i].scalars->empty());
        for (const float scalar : *shown->drawables[i].scalars) ASSERT_EQ(scalar, value);
    }
}

TEST_P(scene_geometry, what_a_scene_says_of_colors_arrives_at_the_renderer) {
    json layer = slice(1);
    layer["color"] = {{"array", "p"}, {"log", true}, {"reverse", true}, {"steps", 6}, {"above", "#ff0000"}};
    const json document = scene_of({{"s", layer}});
    const auto shown = show(document);
    const color::ColorScale& scale = shown->drawables.at(0).scale;
    EXPECT_TRUE(scale.log && scale.reverse);
    EXPECT_EQ(scale.steps, 6);
    EXPECT_EQ(scale.above, (color::Rgb8{255, 0, 0}));
    EXPECT_EQ(scale.range, (std::array<double, 2>{36e-6, 36})) << "p reaches down to zero: six decades are shown";
    EXPECT_EQ(frames::frame_of(*shown, {scene::parse(document), loaded}, 32, 32, 1).primitives.at(0).scale, scale);
    EXPECT_TRUE(shown->lacking.empty());
}

TEST_P(scene_geometry, an_array_without_a_logarithm_is_said_to_have_no_colors) {
    json layer = slice(1);
    layer["color"] = {{"array", "U:z"}, {"log", true}}; // U:z goes from -6 to 0
    const auto shown = show(scene_of({{"s", layer}}));
    ASSERT_EQ(shown->lacking.size(), 1U);
    EXPECT_EQ(shown->lacking[0],
              "layer s has no colors: U:z has no value above zero at this time; choose a linear scale");
    EXPECT_EQ(shown->drawables.size(), 1U) << "it is shown all the same";
}

TEST_P(scene_geometry, only_what_changed_is_computed_again) {
    json document = scene_of({{"i", iso({5, 20})}, {"s", slice(1)}});
    const auto first = show(document);
    const auto again = show(document);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(first->drawables[i].shape, again->drawables[i].shape);
        EXPECT_EQ(first->drawables[i].revision, again->drawables[i].revision);
    }
    document["layers"]["i"]["color"] = {{"map", "grayscale"}, {"solid", "#ff0000"}};
    document["layers"]["i"]["opacity"] = 0.5;
    const auto styled = show(document);
    EXPECT_EQ(styled->drawables[0].revision, first->drawables[0].revision);
    EXPECT_EQ(styled->drawables[0].color, (std::array<float, 4>{1, 0, 0, 0.5F}));

    document["layers"]["i"]["values"] = {5, 21};
    document["layers"]["s"]["value"] = 1002;
    const auto moved = show(document);
    EXPECT_EQ(moved->drawables[0].shape, first->drawables[0].shape);
    EXPECT_NE(moved->drawables[1].shape, first->drawables[1].shape);
    EXPECT_EQ(moved->drawables[1].identity, first->drawables[1].identity);
    EXPECT_NE(moved->drawables[1].revision, first->drawables[1].revision);
    EXPECT_NE(moved->drawables[2].shape, first->drawables[2].shape);

    document["layers"]["i"]["color"]["array"] = "U:magnitude";
    const auto painted = show(document);
    EXPECT_EQ(painted->drawables[0].shape, first->drawables[0].shape);
    EXPECT_NE(painted->drawables[0].revision, first->drawables[0].revision);
}

TEST_P(scene_geometry, hidden_layers_keep_their_state_and_removed_ones_give_it_back) {
    json document = scene_of({{"i", iso({20})}, {"b", {{"type", "surface"}}}});
    const auto first = show(document);
    const std::size_t bytes = geometry.memory_bytes();
    EXPECT_GT(bytes, 0U);
    document["layers"]["i"]["visible"] = false;
    EXPECT_EQ(show(document)->drawables.size(), 1U);
    EXPECT_EQ(geometry.memory_bytes(), bytes);
    document["layers"]["i"]["visible"] = true;
    EXPECT_EQ(show(document)->drawables[1].shape, first->drawables[1].shape);
    document["layers"] = json::object();
    EXPECT_TRUE(show(document)->drawables.empty());
    EXPECT_EQ(geometry.memory_bytes(), 0U);
}

TEST_P(scene_geometry, a_scene_that_is_too_large_is_never_made) {
    const std::size_t of_one = (show(scene_of({{"a", iso({20})}})), geometry.memory_bytes());
    json layers;
    for (char id = 'a'; id <= 'h'; ++id) layers[std::string(1, id)] = iso({20, 20, 20, 20});
    const auto document = scene::parse(scene_of(layers));
    const std::size_t most = 5 * of_one / 2;
    EXPECT_THROW((void)geometry.update({document, loaded}, {}, most), limits::LimitReached);
    EXPECT_EQ(geometry.memory_bytes(), 3 * of_one) << "it ends with the surface that passes the limit";
    EXPECT_EQ(geometry.update({document, loaded}, {}, 32 * of_one)->drawables.size(), 32U);
}

TEST_P(scene_geometry, what_a_scene_no_longer_shows_makes_room_for_what_it_shows) {
    const std::size_t of_one = (show(scene_of({{"a", iso({20})}})), geometry.memory_bytes());
    const auto other = scene::parse(scene_of({{"b", iso({20})}}));
    EXPECT_NO_THROW((void)geometry.update({other, loaded}, {}, of_one));
}

TEST_P(scene_geometry, any_history_gives_the_same_surface) {
    for (const double value : {3.0, 4.0, 30.0, 4.5, 12.0, -100.0, 12.25}) {
        const auto kept = show(scene_of({{"i", iso({value})}}));
        SceneGeometry fresh(Algorithm::signatures);
        const auto anew = fresh.update({scene::parse(scene_of({{"i", iso({value})}})), loaded});
        const Surface &a = kept->drawables[0].shape->surface, &b = anew->drawables[0].shape->surface;
        EXPECT_EQ(a.positions, b.positions);
        EXPECT_EQ(a.normals, b.normals);
        EXPECT_EQ(a.polygon_vertex, b.polygon_vertex);
    }
}

TEST_P(scene_geometry, a_requested_stop_returns_nothing_and_harms_nothing) {
    std::stop_source stop;
    stop.request_stop();
    const auto document = scene::parse(scene_of({{"i", iso({20})}}));
    EXPECT_EQ(geometry.update({document, loaded}, stop.get_token()), nullptr);
    EXPECT_GT(geometry.update({document, loaded})->triangles, 0U);
}

TEST_P(scene_geometry, an_array_that_was_not_written_is_lacking_and_never_zeros) {
    json late = iso({30});
    late["array"] = "late";
    json colored = slice(2);
    colored["color"]["array"] = "late";
    json document = scene_of({{"i", late}, {"p", iso({20})}, {"s", colored}});
    const auto at_0 = show(document);
    ASSERT_EQ(at_0->drawables.size(), 2U) << "without the layer that has no values";
    EXPECT_FALSE(at_0->drawables[1].scalars);
    EXPECT_EQ(at_0->drawables[1].array, "");
    ASSERT_EQ(at_0->lacking.size(), 2U);
    EXPECT_EQ(at_0->lacking[0], "layer i is not shown: 'late' has no values at time 0; it has values at 2");
    EXPECT_EQ(at_0->lacking[1], "layer s has no colors: 'late' has no values at time 0; it has values at 2");
    EXPECT_THROW(require_complete(*at_0), store::NotWritten);
    document["time"] = 2;
    const auto at_2 = show(document);
    EXPECT_EQ(at_2->drawables.size(), 3U);
    EXPECT_TRUE(at_2->drawables[2].scalars);
    EXPECT_NO_THROW(require_complete(*at_2));
}

TEST_P(scene_geometry, names_are_checked_with_their_path) {
    const struct {
        json layer;
        const char* path;
    } rows[] = {{{{"type", "iso"}, {"array", "nope"}, {"values", {1}}}, "/layers/a~1b/array"},
                {{{"type", "iso"}, {"array", "cell:q"}, {"values", {1}}}, "/layers/a~1b/array"},
                {{{"type", "surface"}, {"color", {{"array", "U:w"}}}}, "/layers/a~1b/color/array"},
                {{{"type", "surface"}, {"color", {{"map", "beige"}}}}, "/layers/a~1b/color/map"},
                {{{"type", "surface"}, {"groups", {"left", "right"}}}, "/layers/a~1b/groups/1"},
                {{{"type", "surface"}, {"groups", {"half"}}}, "/layers/a~1b/groups/0"}};
    for (const auto& row : rows) {
        try {
            show(scene_of({{"a/b", row.layer}}));
            ADD_FAILURE() << row.layer << " was accepted";
        } catch (const scene::Invalid& error) {
            EXPECT_EQ(error.path, row.path) << error.what();
        }
    }
}

TEST_P(scene_geometry, the_frame_borrows_and_draws_opaque_layers_first) {
    json glass = slice(1);
    glass["opacity"] = 0.5;
    glass["order"] = -1;
    const scene::CheckedScene checked(
        scene::parse(scene_of({{"i", iso({20})}, {"s", glass}, {"o", {{"type", "outline"}}}})), loaded);
    const auto shown = geometry.update(checked);
    const render::Frame frame = frames::frame_of(*shown, checked, 320, 200, 4);
    ASSERT_EQ(frame.primitives.size(), 3U);
    EXPECT_EQ(frame.primitives[2].color[3], 0.5F);
    const std::size_t drawn_from[] = {1, 2, 0}; // drawables are in layer order: glass, iso, outline
    for (std::size_t i = 0; i < 3; ++i) {
        const render::Primitives& primitives = frame.primitives[i];
        const Drawable& drawable = shown->drawables.at(drawn_from[i]);
        EXPECT_EQ(primitives.positions.data(), drawable.shape->surface.positions.data()) << i;
        EXPECT_EQ(primitives.normals.data(), drawable.shape->surface.normals.data()) << i;
        EXPECT_EQ(primitives.indices.data(), drawable.shape->indices.data()) << i;
        EXPECT_EQ(primitives.scalars.data(), drawable.scalars ? drawable.scalars->data() : nullptr) << i;
    }
    EXPECT_EQ(frame.origin, shown->origin);
    EXPECT_EQ(frame.bounds_max[0], test::box_origin[0] + test::box_edge);
    const auto lines = std::find_if(frame.primitives.begin(), frame.primitives.end(),
                                    [](const auto& primitives) { return primitives.lines; });
    ASSERT_NE(lines, frame.primitives.end());
    EXPECT_EQ(lines->indices.size(), 24U);
}

INSTANTIATE_TEST_SUITE_P(algorithms, scene_geometry, testing::Values(Algorithm::signatures, Algorithm::propagation),
                         [](const auto& algorithm) {
                             return algorithm.param == Algorithm::signatures ? "signatures" : "propagation";
                         });

} // namespace
} // namespace server::geometry
