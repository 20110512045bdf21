#include "geometry/volume_cut.hpp"

#include "annotations/camera.hpp"
#include "geometry/scene_geometry.hpp"
#include "store/catalog.hpp"
#include "support/chosen_algorithm.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::geometry {
using namespace ciel;
namespace {

using nlohmann::json;

class volume_cut : public testing::Test {
protected:
    volume_cut() { test::write_small_dataset(folder.path() / "box.ciel"); }

    VolumeDrawable show(const json& layer, bool moving = false, std::vector<double> towards = {1, -9, 2}) {
        return show_all({{"v", layer}}, moving, towards).at(0);
    }
    std::vector<VolumeDrawable> show_all(const json& layers, bool moving = false,
                                         std::vector<double> towards = {1, -9, 2}) {
        json document{{"dataset", "box"}, {"layers", layers}};
        const Vec3d target = test::box_origin;
        document["camera"] = {{"target", target},
                              {"position", {target[0] - towards[0], target[1] - towards[1], target[2] - towards[2]}}};
        if (!loaded) loaded = catalog.open("box");
        return geometry.update({scene::parse(document), loaded}, {}, SIZE_MAX, moving)->volumes;
    }
    static json volume(int slices) { return {{"type", "volume"}, {"array", "p"}, {"slices", slices}}; }
    static std::size_t cut_slices(const VolumeDrawable& drawable) {
        return static_cast<std::size_t>(std::ranges::count_if(
            drawable.slabs->slices, [](const color::SlabTriangles& slice) { return !slice.triangles.empty(); }));
    }

    test::Folder folder;
    store::Catalog catalog{{folder.path()}};
    std::shared_ptr<store::LoadedDataset> loaded;
    SceneGeometry geometry{test::chosen_algorithm()};
};

TEST_F(volume_cut, strides_are_odd_so_that_the_middle_slices_are_those_of_the_still) {
    for (std::size_t slices = 1; slices <= 1000; ++slices) {
        for (const std::size_t vertices : {1U, 200'000U, 900'000U, 2'000'000'000U}) {
            for (const double loss : {0.0, 10.0, 1000.0}) {
                const std::size_t stride = moving_stride(slices, vertices, loss);
                EXPECT_EQ(stride % 2, 1U);
                EXPECT_LE((slices + stride - 1) / stride, loss > 0 ? 96U : 24U);
            }
        }
    }
    EXPECT_EQ(moving_stride(24, 100, 0), 1U);
}

TEST_F(volume_cut, slices_of_a_large_mesh_are_fewer_while_something_moves_but_never_next_to_none) {
    EXPECT_EQ(moving_stride(100, 110'000, 0), 5U);
    EXPECT_EQ(moving_stride(100, 900'000, 0), 7U);
    EXPECT_EQ(moving_stride(100, 2'000'000'000, 0), 13U);
}

TEST_F(volume_cut, slices_of_a_dense_volume_are_more_while_something_moves) {
    EXPECT_EQ(moving_stride(200, 110'000, 8), 7U) << "32 slabs, of which each loses a quarter";
    EXPECT_EQ(moving_stride(200, 110'000, 100), 5U);
    EXPECT_EQ(moving_stride(200, 900'000, 8), 7U);
    EXPECT_EQ(moving_stride(200, 900'000, 100), 7U);
    EXPECT_EQ(moving_stride(400, 10'000, 1000), 5U);
    EXPECT_EQ(moving_stride(200, 2'000'000'000, 100), 13U);
}

TEST_F(volume_cut, a_loss_is_that_of_the_densest_value_over_the_whole_length) {
    const std::vector<std::array<double, 2>> points{{0, 0}, {0.5, 0.75}, {1, 0.5}};
    EXPECT_NEAR(largest_loss(points, 2, 6), 3 * std::log(4), 1e-12);
    EXPECT_EQ(largest_loss({}, 2, 6), 0);
}

TEST_F(volume_cut, slices_that_no_scene_counts_are_as_far_apart_whatever_they_are_across) {
    EXPECT_EQ(usual_slices(5, 5, 1000, 2), 200U);
    EXPECT_EQ(usual_slices(10, 5, 1000, 2), 400U) << "along a long axis";
    EXPECT_EQ(usual_slices(2, 5, 1000, 2), 200U) << "never fewer";
    EXPECT_EQ(usual_slices(50, 5, 1000, 2), 1000U);
    EXPECT_EQ(usual_slices(50, 0, 1000, 2), 200U) << "of a flat mesh";
    json layer = volume(1);
    layer.erase("slices");
    EXPECT_EQ(show(layer).slabs->slices.size(), 200U);
}

TEST_F(volume_cut, slices_that_no_scene_counts_are_more_where_opacity_is_steep_and_the_mesh_not_large) {
    EXPECT_EQ(usual_slices(5, 5, 1000, 15), 300U);
    EXPECT_EQ(usual_slices(5, 5, 1000, 1000), 400U);
    EXPECT_EQ(usual_slices(5, 5, 450'000, 1000), 267U);
    EXPECT_EQ(usual_slices(5, 5, 2'000'000, 1000), 200U);
    const double rise = std::log(10); // extinction at opacity 0.9 minus that at 0
    EXPECT_NEAR(steepness(std::vector<std::array<double, 2>>{{0, 0}, {1, 0.9}}), rise, 1e-12);
    EXPECT_NEAR(steepness(std::vector<std::array<double, 2>>{{0, 0.9}, {0.5, 0.9}, {0.6, 0}}), 10 * rise, 1e-9);
    EXPECT_TRUE(std::isinf(steepness(std::vector<std::array<double, 2>>{{0.5, 0}, {0.5, 0.9}})));
    EXPECT_EQ(steepness({}), 0);
    json layer = volume(1);
    layer.erase("slices");
    layer["opacity_points"] = {{0.4, 0}, {0.41, 0.9}};
    EXPECT_EQ(show(layer).slabs->slices.size(), 400U);
}

TEST_F(volume_cut, slices_are_cut_for_what_gets_denser_while_something_moves) {
    json layer = volume(200);
    layer["opacity_points"] = {{0, 0}, {1, 0.05}};
    const VolumeDrawable thin = show(layer, true);
    EXPECT_EQ(thin.stride, 9U);
    layer["opacity_points"] = {{0, 0.9}, {1, 0.9}};
    const VolumeDrawable thick = show(layer, true);
    EXPECT_LT(thick.stride, 9U);
    EXPECT_EQ(cut_slices(thick), (200 + thick.stride / 2) / thick.stride);
    EXPECT_NE(thick.revision, thin.revision);
}

TEST_F(volume_cut, only_what_is_drawn_while_something_moves_is_cut_and_the_rest_for_the_still) {
    const VolumeDrawable moving = show(volume(100), true);
    EXPECT_EQ(moving.stride, 3U);
    EXPECT_EQ(cut_slices(moving), 33U);
    const VolumeDrawable still = show(volume(100));
    EXPECT_EQ(still.stride, 1U);
    EXPECT_EQ(cut_slices(still), 100U);
    EXPECT_EQ(still.identity, moving.identity);
    EXPECT_NE(still.revision, moving.revision);
    const geometry::VolumeDrawable again = show(volume(100), true, {2, -9, 1}); // another view with the same slice axis
    EXPECT_EQ(again.slabs, still.slabs);
    EXPECT_EQ(again.revision, still.revision);
}

TEST_F(volume_cut, the_axis_is_the_one_nearest_to_the_view_or_the_one_that_is_asked_for) {
    EXPECT_EQ(show(volume(3)).slabs->normal, (Vec3d{0, 1, 0}));
    EXPECT_EQ(show(volume(3), false, {-8, 1, 2}).slabs->normal, (Vec3d{1, 0, 0}));
    json layer = volume(3);
    layer["direction"] = "z";
    EXPECT_EQ(show(layer, false, {1, 8, 6}).slabs->normal, (Vec3d{0, 0, 1}));
    layer["direction"] = "screen";
    EXPECT_EQ(show(layer, true).slabs->normal, (Vec3d{0, 1, 0})) << "while the camera moves";
    const Vec3d normal = show(layer, false, {0, 3, 4}).slabs->normal;
    EXPECT_NEAR(normal[1], 0.6, 1e-12);
    EXPECT_NEAR(normal[2], 0.8, 1e-12);
}

TEST_F(volume_cut, a_wide_still_has_no_slabs_that_it_looks_along) {
    const auto normal = [](const Vec3d& view, double fov, bool moving = false, bool parallel = false) {
        annotations::ViewCamera camera;
        camera.position = {};
        camera.target = view;
        camera.fov_degrees = fov;
        camera.parallel = parallel;
        return slab_normal(scene::VolumeLayer::Direction::automatic, camera, moving);
    };
    const Vec3d x{1, 0, 0}, corner{1, 1, 1};
    EXPECT_EQ(normal(corner, 30), x);
    EXPECT_NEAR(normal(corner, 60)[2], 1 / std::sqrt(3.0), 1e-12);
    EXPECT_EQ(normal(corner, 60, true), x) << "while the camera moves";
    EXPECT_EQ(normal(corner, 60, false, true), x) << "parallel";
    EXPECT_EQ(normal({2, 0.01, 0}, 75), x) << "straight at them";
    EXPECT_NE(normal({2, 0.01, 0}, 170), x);
}

TEST(slab_normal, is_across_the_axis_asked_for_unless_the_camera_looks_along_such_slabs) {
    using Direction = scene::VolumeLayer::Direction;
    const Vec3d x{1, 0, 0}, y{0, 1, 0};
    annotations::ViewCamera camera;
    for (const bool moving : {false, true})
        for (const bool parallel : {false, true}) {
            camera.parallel = parallel;
            camera.target = {3, 2.6, 0};
            EXPECT_EQ(slab_normal(Direction::y, camera, moving), y) << "49 degrees from it, though x is nearer";
            camera.target = {1, 0.02, 0};
            EXPECT_EQ(slab_normal(Direction::y, camera, moving), x) << "along its slabs";
        }
    camera.parallel = false;
    camera.fov_degrees = 75;
    camera.target = {1, 1, 0.02};
    EXPECT_NEAR(slab_normal(Direction::z, camera, false)[0], std::sqrt(0.5), 1e-3) << "wide: across the view";
}

TEST_F(volume_cut, all_volumes_have_slabs_across_the_direction_of_the_first_that_is_shown) {
    const auto across = [](const char* direction, double order, bool visible = true) {
        json layer = volume(3);
        layer["direction"] = direction;
        layer["order"] = order;
        layer["visible"] = visible;
        return layer;
    };
    const json layers{{"a", across("x", 3)}, {"b", across("screen", 2)}, {"hidden", across("z", 1, false)}};
    const std::vector<VolumeDrawable> still = show_all(layers, false, {0, 3, 4});
    ASSERT_EQ(still.size(), 2U);
    EXPECT_NEAR(still[0].slabs->normal[2], 0.8, 1e-12);
    EXPECT_EQ(still[1].slabs->normal, still[0].slabs->normal);
    for (const VolumeDrawable& moving : show_all(layers, true, {0, 3, 4}))
        EXPECT_EQ(moving.slabs->normal, (Vec3d{0, 0, 1}));
}

TEST_F(volume_cut, range_and_unit_length_are_the_scenes_or_the_arrays_and_the_bounds) {
    const VolumeDrawable plain = show(volume(3));
    EXPECT_NEAR(plain.unit_length, 0.1 * std::sqrt(3.0) * 6, 1e-9); // the box has edges of 6
    json layer = volume(3);
    layer["unit_length"] = 2;
    layer["color"] = {{"range", {1, 2}}, {"map", "inferno"}};
    const VolumeDrawable chosen = show(layer);
    EXPECT_EQ(chosen.unit_length, 2);
    EXPECT_EQ(chosen.scale.range, (std::array<double, 2>{1, 2}));
    EXPECT_EQ(chosen.scale.map, "inferno");
}

} // namespace
} // namespace server::geometry
