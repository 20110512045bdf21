#include "geometry/cut_box.hpp"

#include "ciel/vectors.hpp"
#include "geometry/clip_planes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace server::geometry {
namespace {

std::optional<ciel::Vec3d> meet(const ciel::HalfSpace& a, const ciel::HalfSpace& b, const ciel::HalfSpace& c) {
    const ciel::Vec3d bc = ciel::cross(b.normal, c.normal);
    const ciel::Vec3d ca = ciel::cross(c.normal, a.normal);
    const ciel::Vec3d ab = ciel::cross(a.normal, b.normal);
    const double volume = ciel::dot(a.normal, bc);
    if (!(std::abs(volume) > 1e-9)) return {};
    ciel::Vec3d point{};
    for (std::size_t k = 0; k < 3; ++k) point[k] = -(a.offset * bc[k] + b.offset * ca[k] + c.offset * ab[k]) / volume;
    return point;
}

std::vector<ciel::HalfSpace> unit_length(std::vector<ciel::HalfSpace> planes) {
    for (ciel::HalfSpace& plane : planes) {
        const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
        for (double& component : plane.normal) component /= length;
        plane.offset /= length;
    }
    return planes;
}

} // namespace

// A corner is a point at which three planes meet and that lies on the kept side of all other planes.
std::vector<ciel::Vec3d> corners_of_cut_box(const Geometry& geometry, const std::vector<ciel::HalfSpace>& cutting) {
    std::vector<ciel::HalfSpace> planes = unit_length(cutting);
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double low = geometry.bounds_min[k] - geometry.origin[k];
        const double high = geometry.bounds_max[k] - geometry.origin[k];
        size = std::max({size, std::abs(low), std::abs(high)});
        ciel::Vec3d inward{};
        inward[k] = 1;
        planes.push_back({inward, -low});
        inward[k] = -1;
        planes.push_back({inward, high});
    }
    std::vector<ciel::Vec3d> corners;
    const double rounding = 1e-9 * size;
    for (std::size_t i = 0; i < planes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (std::size_t k = 0; k < j; ++k)
                if (const auto corner = meet(planes[i], planes[j], planes[k]);
                    corner && std::all_of(planes.begin(), planes.end(), [&](const ciel::HalfSpace& plane) {
                        return distance(plane, *corner) >= -rounding;
                    }))
                    corners.push_back(*corner);
    return corners;
}

} // namespace server::geometry
