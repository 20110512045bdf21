#include "frames/pixel_grid.hpp"

#include "ciel/clip_polygon.hpp"
#include "ciel/vector_operators.hpp"
#include "wire/batches/quantize.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace server::frames {

using ciel::operator-;

namespace {

constexpr double of_a_pixel = 0.25;
constexpr double of_a_height = 1.0 / 32;     // of a triangle's height; this tilts the triangle by 1 degree on average
constexpr double nearest_of_farthest = 1e-4; // least visible depth as a fraction of the largest, as in the renderer
constexpr std::size_t sampled_triangles = 4096;
constexpr double small_heights = 0.1; // quantile of the triangle heights that limits the step

ciel::Vec3d unit(const ciel::Vec3d& a) {
    const double by = ciel::length(a);
    return by > 0 ? ciel::Vec3d{a[0] / by, a[1] / by, a[2] / by} : ciel::Vec3d{};
}
ciel::Vec3d position(const ciel::Surface& surface, ciel::Index vertex) {
    const ciel::Vec3f& p = surface.positions[vertex];
    return {p[0], p[1], p[2]};
}

class Frustum {
public:
    Frustum(const geometry::Geometry& geometry, const annotations::ViewCamera& camera, const geometry::ViewSize& size)
        : eye_(camera.position - geometry.origin), forward_(unit(camera.target - camera.position)),
          right_(unit(ciel::cross(forward_, camera.up))), up_(ciel::cross(right_, forward_)),
          tan_(std::tan(camera.fov_degrees * std::numbers::pi / 360)),
          tan_across_(tan_ * static_cast<double>(size.width) / std::max(size.height, 1U)) {
        double farthest = 0;
        nearest_corner_ = INFINITY;
        for (unsigned corner = 0; corner < 8; ++corner) {
            ciel::Vec3d at{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                at[axis] = ((corner >> axis) & 1U) != 0 ? geometry.bounds_max[axis] : geometry.bounds_min[axis];
            const double depth = ciel::dot(forward_, at - camera.position);
            farthest = std::max(farthest, depth);
            nearest_corner_ = std::min(nearest_corner_, depth);
        }
        nearest_ = nearest_of_farthest * farthest;
    }

    [[nodiscard]] double nearest() const { return nearest_; }
    // Returns the depth of the nearest corner of the bounds. Negative if the corner is behind the camera.
    [[nodiscard]] double nearest_corner() const { return nearest_corner_; }

    // Returns the coordinates along the axes of the camera: right, up, forward (depth).
    [[nodiscard]] ciel::Vec3d place(const ciel::Vec3f& p) const {
        const ciel::Vec3d at{p[0] - eye_[0], p[1] - eye_[1], p[2] - eye_[2]};
        return {ciel::dot(right_, at), ciel::dot(up_, at), ciel::dot(forward_, at)};
    }
    // Returns a number for each side (right, left, top, bottom, near): negative if the point is outside of the side.
    [[nodiscard]] std::array<double, 5> inside(const ciel::Vec3d& at) const {
        const double half_width = at[2] * tan_across_, half_height = at[2] * tan_;
        return {half_width - at[0], half_width + at[0], half_height - at[1], half_height + at[1], at[2] - nearest_};
    }
    [[nodiscard]] std::uint8_t outside(const ciel::Vec3d& at) const {
        unsigned bits = 0;
        const auto distances = inside(at);
        for (unsigned side = 0; side < distances.size(); ++side) bits |= distances[side] < 0 ? 1U << side : 0U;
        return static_cast<std::uint8_t>(bits);
    }
    // Returns the least depth of a polygon in the frustum; infinity if nothing is inside. Overwrites both arguments.
    [[nodiscard]] double nearest_of(std::vector<ciel::Vec3d>& corners, std::vector<ciel::Vec3d>& clipped) const {
        for (std::size_t side = 0; side < 5; ++side) {
            ciel::clip_polygon(
                corners, [&](const ciel::Vec3d& at) { return inside(at)[side]; }, clipped);
            corners.swap(clipped);
        }
        double nearest = INFINITY;
        for (const ciel::Vec3d& at : corners) nearest = std::min(nearest, at[2]);
        return nearest;
    }

private:
    ciel::Vec3d eye_, forward_, right_, up_;
    double tan_, tan_across_, nearest_ = 0, nearest_corner_ = 0;
};

double nearest_depth(const geometry::Drawable& drawable, const Frustum& frustum) {
    std::vector<ciel::Vec3d> places;
    std::vector<std::uint8_t> outside;
    for (const ciel::Vec3f& at : drawable.shape->surface.positions) {
        places.push_back(frustum.place(at));
        outside.push_back(frustum.outside(places.back()));
    }
    double nearest = INFINITY;
    std::vector<ciel::Vec3d> corners, clipped;
    const auto indices = drawable.indices();
    const std::size_t count = drawable.corners();
    for (std::size_t i = 0; i < indices.size(); i += count) {
        unsigned all = 0xFF, any = 0;
        double least = INFINITY;
        corners.clear();
        for (const ciel::Index vertex : indices.subspan(i, count)) {
            all &= outside[vertex];
            any |= outside[vertex];
            least = std::min(least, places[vertex][2]);
            corners.push_back(places[vertex]);
        }
        if (all != 0 || least >= nearest) continue;
        nearest = std::min(nearest, any == 0 ? least : frustum.nearest_of(corners, clipped));
    }
    return nearest;
}

double flat_height(const geometry::Geometry& geometry) {
    double least = INFINITY;
    for (const geometry::Drawable& drawable : geometry.drawables) {
        const ciel::Surface& surface = drawable.shape->surface;
        const auto indices = drawable.indices();
        if (!drawable.lit || !drawable.polygons() || !surface.normals.empty() || indices.empty()) continue;
        const std::size_t stride = 3 * (indices.size() / 3 / sampled_triangles + 1);
        std::vector<double> heights;
        for (std::size_t i = 0; i < indices.size(); i += stride) {
            const ciel::Vec3d a = position(surface, indices[i]), b = position(surface, indices[i + 1]),
                              c = position(surface, indices[i + 2]);
            const double longest = std::max({ciel::length(b - a), ciel::length(c - b), ciel::length(a - c)});
            const double area = ciel::length(ciel::cross(b - a, c - a));
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

double largest_offset(const geometry::Geometry& geometry) {
    double largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double bound : {geometry.bounds_min[axis], geometry.bounds_max[axis]})
            largest = std::max(largest, std::abs(bound - geometry.origin[axis]));
    return largest;
}

// Returns the distance from the origin at which the grid need not be finer than the resolution of floats.
double looked_at(const geometry::Geometry& geometry, const annotations::ViewCamera& camera) {
    const double nearest =
        std::max(ciel::length(camera.position - geometry.origin), ciel::length(camera.target - geometry.origin));
    return std::min(nearest, largest_offset(geometry));
}

// The step is larger than `wanted` if floats are coarser, or if a coordinate in steps would exceed 30 bits.
double step_for(double wanted, const geometry::Geometry& geometry, const annotations::ViewCamera& camera) {
    const double finest = std::ldexp(largest_offset(geometry), -29);
    return wire::grid_step(std::max(wanted, finest), looked_at(geometry, camera));
}

double pixel_at(double depth, const annotations::ViewCamera& camera, const geometry::ViewSize& size) {
    return 2 * std::tan(camera.fov_degrees * std::numbers::pi / 360) * depth / std::max(size.height, 1U);
}

} // namespace

double nearest_pixel(const geometry::Geometry& geometry, const annotations::ViewCamera& camera,
                     const geometry::ViewSize& size) {
    if (camera.parallel) return camera.parallel_height / std::max(size.height, 1U);
    const Frustum frustum(geometry, camera, size);
    double nearest = INFINITY;
    for (const geometry::Drawable& drawable : geometry.drawables)
        nearest = std::min(nearest, nearest_depth(drawable, frustum));
    if (!(nearest < INFINITY)) nearest = ciel::length(camera.target - camera.position); // nothing is in view
    return pixel_at(std::max(nearest, frustum.nearest()), camera, size);
}

double surely_fine_grid(const geometry::Geometry& geometry, const annotations::ViewCamera& camera,
                        const geometry::ViewSize& size) {
    double pixel = 0;
    if (camera.parallel)
        pixel = nearest_pixel(geometry, camera, size);
    else
        pixel = pixel_at(std::max(0.0, Frustum(geometry, camera, size).nearest_corner()), camera, size);
    return pixel > 0 ? step_for(of_a_pixel * pixel, geometry, camera) : 0;
}

double needed_grid(const geometry::Geometry& geometry, const annotations::ViewCamera& camera,
                   const geometry::ViewSize& size) {
    return step_for(std::min(of_a_pixel * nearest_pixel(geometry, camera, size), of_a_height * flat_height(geometry)),
                    geometry, camera);
}

} // namespace server::frames
