// Compares pictures of volumes with the expected light of each pixel's ray, from several views.
#pragma once

#include "volume_scene.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;

inline constexpr int side = 160;

inline Renderer& renderer() {
    static Renderer one(Backend::automatic);
    return one;
}

struct View {
    const char* name;
    Vec3d from; // direction from the target to the eye
    double fov; // degrees; 0 for a parallel camera
    double distance = 3;

    friend std::ostream& operator<<(std::ostream& out, const View& view) { return out << view.name; }
};

inline const std::vector<View> views{
    {"along_y_parallel", {0.001, -1, 0.002}, 0}, {"slanted_parallel", {0.4, -1, 0.3}, 0},
    {"corner_parallel", {1, 1, 1}, 0},           {"along_x", {1, 0.003, 0.001}, 30},
    {"slanted", {-0.5, 0.9, 0.45}, 30},          {"below", {0.3, 0.2, -1}, 45},
    {"forty_five_degrees", {1, 0.99, 0.02}, 30}, {"corner_wide", {-1, -1, 1}, 80, 1.3},
    {"eye_inside", {0.3, -1, 0.4}, 70, 0.3},     {"eye_inside_parallel", {0.3, -1, 0.4}, 0, 0.3},
};

// Frame of side x side pixels with a black background, centered on the box from `low` to `high`.
inline Frame frame_of(const View& view, const Vec3d& low = {0, 0, 0}, const Vec3d& high = {1, 1, 1}) {
    Frame frame;
    frame.width = frame.height = side;
    frame.bounds_min = low;
    frame.bounds_max = high;
    const Vec3d middle{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
    frame.camera.target = middle;
    frame.camera.position = plus(middle, unit_of(view.from), view.distance);
    frame.camera.parallel = view.fov == 0;
    frame.camera.parallel_height = 2;
    if (!frame.camera.parallel) frame.camera.fov_degrees = view.fov;
    return frame;
}

// Plane as (xyz, w); points with dot(xyz, p) + w >= 0 are kept.
inline std::array<float, 4> plane_through(const Vec3d& point, const Vec3d& kept) {
    const Vec3d n = unit_of(kept);
    return {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2]),
            static_cast<float>(-(n[0] * point[0] + n[1] * point[1] + n[2] * point[2]))};
}

struct Cut {
    const char* name;
    std::vector<std::array<float, 4>> planes;

    [[nodiscard]] std::array<double, 2> kept(const Ray& ray, std::array<double, 2> span) const {
        for (const auto& [x, y, z, w] : planes) {
            const double inside = x * ray[0][0] + y * ray[0][1] + z * ray[0][2] + w;
            const double rate = x * ray[1][0] + y * ray[1][1] + z * ray[1][2];
            if (rate > 0) span[0] = std::max(span[0], -inside / rate);
            if (rate < 0) span[1] = std::min(span[1], -inside / rate);
            if (rate == 0 && inside < 0) span[1] = span[0];
        }
        return span;
    }
    friend std::ostream& operator<<(std::ostream& out, const Cut& cut) { return out << cut.name; }
};

struct Difference {
    double largest = 0, mean = 0; // in 255ths; `mean` is signed
    int x = 0, y = 0;             // pixel with the largest difference
    int beyond = 0, pixels = 0;   // pixels beyond the tolerance, and pixels that are not black in both pictures
};

// `expected` returns the light of a ray, from 0 to 1. `share` is the relative tolerance.
inline Difference compare(const Frame& frame, const std::function<double(const Ray&)>& expected, double share) {
    Image image;
    renderer().draw(frame, image);
    Difference difference;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            const double wanted = 255 * expected(ray_of(frame, x + 0.5, y + 0.5));
            const double seen = image.rgb[3 * static_cast<std::size_t>(y * frame.width + x)];
            if (wanted == 0 && seen == 0) continue;
            const double off = seen - wanted;
            ++difference.pixels;
            difference.mean += off;
            if (std::abs(off) > std::abs(difference.largest)) {
                difference.largest = off;
                difference.x = x;
                difference.y = y;
            }
            if (std::abs(off) > share * wanted + 0.75) ++difference.beyond;
        }
    difference.mean /= std::max(1, difference.pixels);
    return difference;
}

// The rasterizer snaps vertices to 1/256 pixel, so a pixel on the mesh's outline may be covered in one picture only.
inline void expect_close(const Difference& difference, const std::string& what) {
    EXPECT_GT(difference.pixels, side * side / 20) << what;
    EXPECT_LE(difference.beyond, difference.pixels / 500)
        << what << ", most of all by " << difference.largest << " at " << difference.x << ", " << difference.y;
    EXPECT_LT(std::abs(difference.mean), 0.6) << what; // rounding all pixels in the same direction gives a mean of 0.5
}

inline Vec3d nearest_axis(const Vec3d& v) {
    std::size_t axis = 0;
    for (std::size_t other = 1; other < 3; ++other)
        if (std::abs(v[other]) > std::abs(v[axis])) axis = other;
    Vec3d normal{};
    normal[axis] = 1;
    return normal;
}

} // namespace server::render
