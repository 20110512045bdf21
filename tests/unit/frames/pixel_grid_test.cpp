#include "frames/pixel_grid.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace server::frames {
namespace {

// Square with the given side, `depth` in front of a camera at the origin that looks along x. The bounds have side 100.
geometry::Geometry square(float depth, float side, float across = 0) {
    auto shape = std::make_shared<geometry::Shape>();
    const float h = side / 2;
    shape->surface.positions = {
        {depth, across - h, -h}, {depth, across + h, -h}, {depth, across + h, h}, {depth, across - h, h}};
    shape->surface.normals.assign(4, {-1, 0, 0});
    shape->indices = {0, 1, 2, 0, 2, 3};
    geometry::Geometry geometry;
    geometry.bounds_min = {-50, -50, -50};
    geometry.bounds_max = {50, 50, 50};
    geometry::Drawable drawable;
    drawable.shape = shape;
    geometry.drawables.push_back(drawable);
    return geometry;
}

const annotations::ViewCamera camera{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 30, false, 1};
constexpr geometry::ViewSize size{1280, 720, 1};

double pixel_at(double depth) { return 2 * depth * std::tan(15 * std::numbers::pi / 180) / 720; }

// protocol/frame.md promises at any zoom: half a grid step along each axis is less than 0.22 pixels.
TEST(pixel_grid, is_a_quarter_of_a_pixel_at_any_distance) {
    for (const float depth : {49.0F, 10.0F, 1.0F, 0.1F}) {
        const double step = needed_grid(square(depth, depth / 10), camera, size);
        EXPECT_LE(step, pixel_at(depth) / 4) << depth;
        EXPECT_GE(step, pixel_at(depth) / 8) << depth << ": twice as fine as needed costs bytes";
        EXPECT_LE(std::sqrt(3.0) * step / 2, 0.22 * pixel_at(depth));
    }
}

TEST(pixel_grid, follows_what_is_nearest_in_view) {
    geometry::Geometry geometry = square(40, 4);
    geometry.drawables.push_back(square(2, 0.1F).drawables.front());
    EXPECT_LE(needed_grid(geometry, camera, size), pixel_at(2) / 4);
    geometry.drawables.back() = square(2, 0.1F, 30).drawables.front(); // the square is beside the view
    EXPECT_GT(needed_grid(geometry, camera, size), pixel_at(40) / 8);
    geometry.drawables.back() = square(-2, 0.1F).drawables.front(); // the square is behind the eye
    EXPECT_GT(needed_grid(geometry, camera, size), pixel_at(40) / 8);
    // All corners are beside the view, the center is inside.
    geometry.drawables.back() = square(2, 80).drawables.front();
    EXPECT_LE(needed_grid(geometry, camera, size), pixel_at(2) / 4);
}

// A line that passes the eye counts from the depth at which it enters the view.
TEST(pixel_grid, of_what_passes_the_eye_counts_what_is_seen_of_it) {
    geometry::Geometry geometry = square(40, 4);
    auto line = std::make_shared<geometry::Shape>();
    line->lines = true;
    line->surface.positions = {{-50, -10, 0}, {50, -10, 0}}; // enters the view at a depth of 21
    line->indices = {0, 1};
    geometry.drawables[0].shape = line;
    const double enters = 10 / (std::tan(15 * std::numbers::pi / 180) * 1280 / 720);
    EXPECT_LE(needed_grid(geometry, camera, size), pixel_at(enters) / 4);
    EXPECT_GE(needed_grid(geometry, camera, size), pixel_at(enters) / 8);
}

TEST(pixel_grid, of_a_parallel_view_is_the_same_at_all_depths) {
    annotations::ViewCamera parallel = camera;
    parallel.parallel = true;
    parallel.parallel_height = 7.2;
    const double step = needed_grid(square(40, 4), parallel, size);
    EXPECT_LE(step, 0.0025);
    EXPECT_EQ(step, needed_grid(square(1, 4), parallel, size));
}

TEST(pixel_grid, of_flat_triangles_is_fine_enough_for_their_light) {
    geometry::Geometry geometry = square(40, 0.2F); // covers only a few pixels
    auto flat = std::make_shared<geometry::Shape>(*geometry.drawables[0].shape);
    flat->surface.normals.clear();
    geometry.drawables[0].shape = flat;
    EXPECT_LE(needed_grid(geometry, camera, size), 0.2 / std::numbers::sqrt2 / 32);
    geometry.drawables[0].lit = false;
    EXPECT_GT(needed_grid(geometry, camera, size), pixel_at(40) / 8);
}

TEST(pixel_grid, of_the_bounds_is_as_fine_and_reads_no_positions) {
    const geometry::Geometry geometry = square(40, 4);
    annotations::ViewCamera outside = camera;
    for (const double away : {60.0, 200.0, 3000.0}) {
        outside.position = {-away, 10, 0};
        const double quick = surely_fine_grid(geometry, outside, size);
        EXPECT_GT(quick, 0);
        EXPECT_LE(quick, needed_grid(geometry, outside, size)) << away;
    }
    EXPECT_EQ(surely_fine_grid(geometry, camera, size), 0) << "the eye is inside";
    geometry::Geometry unread = geometry;
    unread.drawables[0].shape = nullptr;
    EXPECT_GT(surely_fine_grid(unread, outside, size), 0);
}

TEST(pixel_grid, is_never_finer_than_floats_where_the_camera_looks) {
    geometry::Geometry geometry = square(30.001F, 40);
    geometry.origin = {-30, 0, 0};
    EXPECT_GE(needed_grid(geometry, camera, size), 30 * std::ldexp(1.0, -24));
}

// Floats at the ends of the bounds are coarser than a quarter of a pixel. The grid must be fine enough all the same,
// because the origin is near the eye.
TEST(pixel_grid, is_a_quarter_of_a_pixel_at_an_origin_near_the_eye) {
    geometry::Geometry geometry = square(1e-4F, 1e-5F);
    annotations::ViewCamera near = camera;
    near.parallel = true;
    near.parallel_height = 4e-4;
    near.target = {1e-4, 0, 0};
    EXPECT_LE(needed_grid(geometry, near, size), 4e-4 / 720 / 4);
    near.parallel_height = 4e-9;
    EXPECT_GE(needed_grid(geometry, near, size), 50 * std::ldexp(1.0, -30)) << "coordinates have 30 bits";
}

} // namespace
} // namespace server::frames
