#include "geometry/clip_planes.hpp"

#include "ciel/clip_polygon.hpp"
#include "geometry/clip.hpp"

#include <algorithm>

namespace ciel::geometry {

double distance(const HalfSpace& half, const Vec3d& point) {
    return half.normal[0] * point[0] + half.normal[1] * point[1] + half.normal[2] * point[2] + half.offset;
}

Vec3d wide(const Vec3f& point) { return {point[0], point[1], point[2]}; }

ClipPlanes::ClipPlanes(const Geometry& geometry) : planes_(geometry.clip) {
    for (HalfSpace& plane : planes_) plane.offset += clip_slack(geometry);
}

bool ClipPlanes::keeps(const Vec3f& point) const {
    return std::all_of(planes_.begin(), planes_.end(),
                       [&](const HalfSpace& plane) { return distance(plane, wide(point)) >= 0; });
}

std::vector<Vec3d> ClipPlanes::rest_of(std::vector<Vec3d> corners) const {
    std::vector<Vec3d> left;
    for (const HalfSpace& plane : planes_) {
        clip_polygon(
            corners, [&](const Vec3d& corner) { return distance(plane, corner); }, left);
        corners.swap(left);
    }
    return corners;
}

} // namespace ciel::geometry
