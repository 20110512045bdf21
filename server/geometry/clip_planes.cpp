#include "geometry/clip_planes.hpp"

#include "ciel/clip_polygon.hpp"
#include "geometry/clip.hpp"

#include <algorithm>

namespace server::geometry {

double distance(const ciel::HalfSpace& half, const ciel::Vec3d& point) {
    return half.normal[0] * point[0] + half.normal[1] * point[1] + half.normal[2] * point[2] + half.offset;
}

ciel::Vec3d wide(const ciel::Vec3f& point) { return {point[0], point[1], point[2]}; }

ClipPlanes::ClipPlanes(const Geometry& geometry) : planes_(geometry.clip) {
    for (ciel::HalfSpace& plane : planes_) plane.offset += clip_slack(geometry);
}

bool ClipPlanes::keeps(const ciel::Vec3f& point) const {
    return std::all_of(planes_.begin(), planes_.end(),
                       [&](const ciel::HalfSpace& plane) { return distance(plane, wide(point)) >= 0; });
}

std::vector<ciel::Vec3d> ClipPlanes::rest_of(std::vector<ciel::Vec3d> corners) const {
    std::vector<ciel::Vec3d> left;
    for (const ciel::HalfSpace& plane : planes_) {
        ciel::clip_polygon(
            corners, [&](const ciel::Vec3d& corner) { return distance(plane, corner); }, left);
        corners.swap(left);
    }
    return corners;
}

} // namespace server::geometry
