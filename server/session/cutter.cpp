#include "session/cutter.hpp"

#include "session/clip.hpp"

#include <algorithm>

namespace ciel::session {

double distance(const HalfSpace& half, const Vec3d& point) {
    return half.normal[0] * point[0] + half.normal[1] * point[1] + half.normal[2] * point[2] + half.offset;
}

Vec3d wide(const Vec3f& point) { return {point[0], point[1], point[2]}; }

std::size_t corners_of(const Drawable& drawable) {
    if (drawable.polygons()) return 3;
    return drawable.lines() ? 2 : 1;
}

Cutter::Cutter(const Geometry& geometry) : planes_(geometry.clip) {
    for (HalfSpace& plane : planes_) plane.offset += clip_slack(geometry);
}

bool Cutter::keeps(const Vec3f& point) const {
    return std::all_of(planes_.begin(), planes_.end(),
                       [&](const HalfSpace& plane) { return distance(plane, wide(point)) >= 0; });
}

std::vector<Vec3d> Cutter::rest_of(std::vector<Vec3d> corners) const {
    for (const HalfSpace& plane : planes_) {
        std::vector<Vec3d> left;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3d &from = corners[i], &to = corners[(i + 1) % corners.size()];
            const double a = distance(plane, from);
            const double b = distance(plane, to);
            if (a >= 0) left.push_back(from);
            if ((a >= 0) == (b >= 0)) continue;
            Vec3d between{};
            for (std::size_t k = 0; k < 3; ++k) between[k] = from[k] + a / (a - b) * (to[k] - from[k]);
            left.push_back(between);
        }
        corners = std::move(left);
    }
    return corners;
}

} // namespace ciel::session
