// Clips points, lines and convex polygons by the clip planes, with the tolerance of the shaders (clip_slack).
#pragma once

#include "geometry/scene_geometry.hpp"

namespace server::geometry {

class ClipPlanes {
public:
    explicit ClipPlanes(const Geometry& geometry);

    [[nodiscard]] bool cuts() const { return !planes_.empty(); }
    [[nodiscard]] bool keeps(const ciel::Vec3f& point) const;
    // Returns the corners of the kept part of a convex polygon (Sutherland and Hodgman 1974); empty if all is cut away.
    [[nodiscard]] std::vector<ciel::Vec3d> rest_of(std::vector<ciel::Vec3d> corners) const;
    [[nodiscard]] const std::vector<ciel::HalfSpace>& planes() const { return planes_; }

private:
    std::vector<ciel::HalfSpace> planes_;
};

[[nodiscard]] double distance(const ciel::HalfSpace& half, const ciel::Vec3d& point);
[[nodiscard]] ciel::Vec3d wide(const ciel::Vec3f& point);

} // namespace server::geometry
