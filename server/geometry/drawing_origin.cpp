#include "geometry/drawing_origin.hpp"

#include "ciel/vector_operators.hpp"

#include <cmath>
#include <numbers>

namespace server::geometry {

using ciel::operator-;

namespace {

// Largest distance from the origin, in view heights. 2^-24 of it is 1/30 of a pixel of a picture with 2160 rows.
constexpr double reach = 256;

double view_height(const annotations::ViewCamera& camera) {
    if (camera.parallel) return camera.parallel_height;
    return 2 * std::tan(camera.fov_degrees * std::numbers::pi / 360) * ciel::length(camera.target - camera.position);
}

} // namespace

ciel::Vec3d drawing_origin(const ciel::Vec3d& middle, const ciel::Vec3d& last, const annotations::ViewCamera& camera) {
    const double far = reach * view_height(camera);
    for (const ciel::Vec3d& origin : {middle, last})
        if (ciel::length(camera.target - origin) <= far) return origin;
    return camera.target;
}

} // namespace server::geometry
