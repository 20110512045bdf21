#include "annotations/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace server::annotations {
namespace {

glm::dvec3 vector_of(const ciel::Vec3d& v) { return {v[0], v[1], v[2]}; }

bool is_finite(const ciel::Vec3d& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

void check(const ViewCamera& camera) {
    if (!is_usable(camera))
        ciel::fail("the camera cannot be used: give finite vectors, a field of view between 0 and 180 degrees and a "
                   "positive height");
}

glm::dmat4 view_matrix(const ViewCamera& camera, const glm::dvec3& origin) {
    const glm::dvec3 eye = vector_of(camera.position) - origin;
    const glm::dvec3 target = vector_of(camera.target) - origin;
    glm::dvec3 ahead = target - eye;
    ahead = glm::length(ahead) > 0 ? glm::normalize(ahead) : glm::dvec3(0, 1, 0);
    glm::dvec3 up = vector_of(camera.up);
    up = glm::length(up) > 0 ? glm::normalize(up) : glm::dvec3(0, 0, 1);
    if (glm::length(glm::cross(ahead, up)) < 1e-6)
        up = std::abs(ahead.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    // glm::lookAt gets an eye at the origin. Very far from the origin, eye + ahead would be rounded to eye.
    return glm::translate(glm::lookAt(glm::dvec3(0), ahead, up), -eye);
}

struct Depths {
    double nearest, farthest; // distances in front of the eye, in world units
};

Depths depths_of_bounds(const Viewpoint& seen, const glm::dmat4& view) {
    Depths depths{1e300, -1e300};
    const glm::dvec3 origin = vector_of(seen.origin);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 point((corner & 1) != 0 ? seen.bounds_max[0] : seen.bounds_min[0],
                               (corner & 2) != 0 ? seen.bounds_max[1] : seen.bounds_min[1],
                               (corner & 4) != 0 ? seen.bounds_max[2] : seen.bounds_min[2]);
        const double depth = -(view * glm::dvec4(point - origin, 1)).z;
        depths.nearest = std::min(depths.nearest, depth);
        depths.farthest = std::max(depths.farthest, depth);
    }
    return depths;
}

} // namespace

bool is_usable(const ViewCamera& camera) {
    return is_finite(camera.position) && is_finite(camera.target) && is_finite(camera.up) && camera.fov_degrees > 0 &&
           camera.fov_degrees < 180 &&
           (!camera.parallel || (camera.parallel_height > 0 && std::isfinite(camera.parallel_height)));
}

ViewTransform view_transform(const Viewpoint& seen) {
    check(seen.camera);
    ViewTransform transform;
    transform.view = view_matrix(seen.camera, vector_of(seen.origin));
    const double diagonal = glm::length(vector_of(seen.bounds_max) - vector_of(seen.bounds_min));
    transform.scale = diagonal > 0 && std::isfinite(diagonal) ? 1 / diagonal : 1;
    const double margin = 0.01 / transform.scale;
    const Depths depths = depths_of_bounds(seen, transform.view);
    const double aspect = static_cast<double>(seen.width) / seen.height;
    if (seen.camera.parallel) {
        const double half = seen.camera.parallel_height / 2;
        const double back = std::max(0.0, 2 * margin - depths.nearest);
        transform.view = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -back)) * transform.view;
        transform.projection = glm::ortho(-half * aspect, half * aspect, -half, half, depths.nearest + back - margin,
                                          depths.farthest + back + margin);
        return transform;
    }
    // If the whole box is behind the eye, any positive range of depths is valid.
    const double farthest = std::max(depths.farthest + margin, margin);
    // A nearer near plane would leave too few of the 24 bits of depth for the rest of the scene.
    const double nearest = std::max(depths.nearest - margin, farthest * 1e-4);
    transform.projection = glm::perspective(glm::radians(seen.camera.fov_degrees), aspect, nearest, farthest);
    return transform;
}

ViewCamera default_camera(ciel::Vec3d bounds_min, ciel::Vec3d bounds_max, double aspect, double fov_degrees) {
    constexpr double margin = 1.06;
    ViewCamera camera;
    camera.fov_degrees = fov_degrees;
    const glm::dvec3 low = vector_of(bounds_min);
    const glm::dvec3 high = vector_of(bounds_max);
    const glm::dvec3 center = (low + high) * 0.5;
    const glm::dvec3 towards_eye = glm::normalize(glm::dvec3(0.55, -1, 0.5));
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), towards_eye));
    const glm::dvec3 up = glm::cross(towards_eye, right);
    const double half_height = std::tan(glm::radians(camera.fov_degrees) / 2);
    double distance = 0;
    double height = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 half = (high - low) * 0.5;
        const glm::dvec3 point((corner & 1) != 0 ? half.x : -half.x, (corner & 2) != 0 ? half.y : -half.y,
                               (corner & 4) != 0 ? half.z : -half.z);
        const double needed = std::max(std::abs(glm::dot(point, right)) / aspect, std::abs(glm::dot(point, up)));
        distance = std::max(distance, glm::dot(point, towards_eye) + margin * needed / half_height);
        height = std::max(height, 2 * margin * needed);
    }
    if (!(distance > 0)) distance = height = 1; // the box is a single point
    const glm::dvec3 eye = center + towards_eye * distance;
    camera.position = {eye.x, eye.y, eye.z};
    camera.target = {center.x, center.y, center.z};
    camera.up = {0, 0, 1};
    camera.parallel_height = height;
    return camera;
}

} // namespace server::annotations
