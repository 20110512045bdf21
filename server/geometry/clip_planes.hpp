// Clips points, lines and convex polygons by the clip planes, with the tolerance of the shaders (clip_slack).
#pragma once

#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

class ClipPlanes {
public:
    explicit ClipPlanes(const Geometry& geometry);

    [[nodiscard]] bool cuts() const { return !planes_.empty(); }
    [[nodiscard]] bool keeps(const Vec3f& point) const;
    // Returns the corners of the remaining part (Sutherland and Hodgman 1974); empty if all is cut away.
    [[nodiscard]] std::vector<Vec3d> rest_of(std::vector<Vec3d> corners) const;
    [[nodiscard]] const std::vector<HalfSpace>& planes() const { return planes_; }

private:
    std::vector<HalfSpace> planes_;
};

[[nodiscard]] double distance(const HalfSpace& half, const Vec3d& point);
[[nodiscard]] Vec3d wide(const Vec3f& point);

} // namespace ciel::geometry
