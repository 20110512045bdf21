#include "session/pixel_grid.hpp"

#include "wire/quantize.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ciel::session {
namespace {

constexpr double of_a_pixel = 0.25;
constexpr double of_a_height = 1.0 / 32;     // 1 degree in the mean
constexpr double nearest_of_farthest = 1e-4; // as the renderer's nearest plane
constexpr std::size_t sampled_triangles = 4096;
constexpr double small_heights = 0.1; // so many of the triangles are less high than those that decide

Vec3d minus(const Vec3d& a, const Vec3d& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Vec3d& a, const Vec3d& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Vec3d& a) { return std::sqrt(dot(a, a)); }
Vec3d cross(const Vec3d& a, const Vec3d& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec3d unit(const Vec3d& a) {
    const double by = length(a);
    return by > 0 ? Vec3d{a[0] / by, a[1] / by, a[2] / by} : Vec3d{};
}
Vec3d position(const Surface& surface, Index vertex) {
    const Vec3f& p = surface.positions[vertex];
    return {p[0], p[1], p[2]};
}

// What of space a perspective camera sees; `eye` as an offset from the geometry's origin.
class Frustum {
public:
    Frustum(const Geometry& geometry, const render::Camera& camera, const ViewSize& size)
        : eye_(minus(camera.position, geometry.origin)), forward_(unit(minus(camera.target, camera.position))),
          right_(unit(cross(forward_, camera.up))), up_(cross(right_, forward_)),
          tan_(std::tan(camera.fov_degrees * std::numbers::pi / 360)),
          tan_across_(tan_ * static_cast<double>(size.width) / std::max(size.height, 1U)) {
        double farthest = 0;
        for (unsigned corner = 0; corner < 8; ++corner) {
            Vec3d at{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                at[axis] = ((corner >> axis) & 1U) != 0 ? geometry.bounds_max[axis] : geometry.bounds_min[axis];
            farthest = std::max(farthest, dot(forward_, minus(at, camera.position)));
        }
        nearest_ = nearest_of_farthest * farthest;
    }

    [[nodiscard]] double nearest() const { return nearest_; }

    struct Seen {
        float depth;
        std::uint8_t outside; // a bit for each side that it lies beyond
    };
    [[nodiscard]] Seen see(const Vec3f& p) const {
        const Vec3d at{p[0] - eye_[0], p[1] - eye_[1], p[2] - eye_[2]};
        const double depth = dot(forward_, at), across = dot(right_, at), above = dot(up_, at);
        const double half_width = depth * tan_across_, half_height = depth * tan_;
        const unsigned outside = (across > half_width ? 1U : 0U) | (across < -half_width ? 2U : 0U) |
                                 (above > half_height ? 4U : 0U) | (above < -half_height ? 8U : 0U) |
                                 (depth < nearest_ ? 16U : 0U);
        return {static_cast<float>(depth), static_cast<std::uint8_t>(outside)};
    }

private:
    Vec3d eye_, forward_, right_, up_;
    double tan_, tan_across_, nearest_ = 0;
};

std::size_t corners_of(const Drawable& drawable) { return drawable.points() ? 1 : drawable.lines() ? 2 : 3; }

// The least depth of what is not all beyond one side; infinite where nothing is seen.
double nearest_depth(const Drawable& drawable, const Frustum& frustum) {
    std::vector<Frustum::Seen> seen;
    seen.reserve(drawable.shape->surface.positions.size());
    for (const Vec3f& at : drawable.shape->surface.positions) seen.push_back(frustum.see(at));
    float nearest = INFINITY;
    const auto indices = drawable.indices();
    const std::size_t corners = corners_of(drawable);
    for (std::size_t i = 0; i < indices.size(); i += corners) {
        Frustum::Seen all{INFINITY, 0xFF};
        for (const Index vertex : indices.subspan(i, corners)) {
            all.outside &= seen[vertex].outside;
            all.depth = std::min(all.depth, seen[vertex].depth);
        }
        if (all.outside == 0) nearest = std::min(nearest, all.depth);
    }
    return nearest;
}

// Heights of triangles whose light comes from their own planes; infinite where there are none.
double flat_height(const Geometry& geometry) {
    double least = INFINITY;
    for (const Drawable& drawable : geometry.drawables) {
        const Surface& surface = drawable.shape->surface;
        const auto indices = drawable.indices();
        if (!drawable.lit || !drawable.polygons() || !surface.normals.empty() || indices.empty()) continue;
        const std::size_t stride = 3 * (indices.size() / 3 / sampled_triangles + 1);
        std::vector<double> heights;
        for (std::size_t i = 0; i < indices.size(); i += stride) {
            const Vec3d a = position(surface, indices[i]), b = position(surface, indices[i + 1]),
                        c = position(surface, indices[i + 2]);
            const double longest = std::max({length(minus(b, a)), length(minus(c, b)), length(minus(a, c))});
            const double area = length(cross(minus(b, a), minus(c, a)));
            if (longest > 0 && area > 0) heights.push_back(area / longest);
        }
        if (heights.empty()) continue;
        const auto small =
            heights.begin() + static_cast<std::ptrdiff_t>(small_heights * static_cast<double>(heights.size()));
        std::nth_element(heights.begin(), small, heights.end());
        least = std::min(least, *small);
    }
    return least;
}

} // namespace

double nearest_pixel(const Geometry& geometry, const render::Camera& camera, const ViewSize& size) {
    const double rows = std::max(size.height, 1U);
    if (camera.parallel) return camera.parallel_height / rows;
    const Frustum frustum(geometry, camera, size);
    double nearest = INFINITY;
    for (const Drawable& drawable : geometry.drawables) nearest = std::min(nearest, nearest_depth(drawable, frustum));
    if (!(nearest < INFINITY)) nearest = length(minus(camera.target, camera.position)); // nothing in view
    return 2 * std::tan(camera.fov_degrees * std::numbers::pi / 360) * std::max(nearest, frustum.nearest()) / rows;
}

double needed_grid(const Geometry& geometry, const render::Camera& camera, const ViewSize& size) {
    double largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double bound : {geometry.bounds_min[axis], geometry.bounds_max[axis]})
            largest = std::max(largest, std::abs(bound - geometry.origin[axis]));
    return wire::grid_step(
        std::min(of_a_pixel * nearest_pixel(geometry, camera, size), of_a_height * flat_height(geometry)), largest);
}

} // namespace ciel::session
