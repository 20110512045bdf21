// Computes matrices from camera and bounds, in double: far from the origin, floats have too few digits for a picture.
#pragma once

#include "ciel/types.hpp"

#include <glm/mat4x4.hpp>

namespace ciel::annotations {

struct Camera {
    Vec3d position{}, target{}, up{0, 0, 1}; // world coordinates
    double fov_degrees = 30;
    bool parallel = false;
    double parallel_height = 1; // world units from the lower to the upper edge of the picture
};

// Returns whether all vectors are finite, the field of view lies between 0 and 180 degrees, and the height of a
// parallel view is positive.
[[nodiscard]] bool is_usable(const Camera& camera);

// The space that a picture shows, and the camera.
struct Viewpoint {
    int width = 0, height = 0; // pixels
    Vec3d origin{};            // offsets are world coordinates less this point
    Camera camera;
    Vec3d bounds_min{}, bounds_max{}; // for the depth range, in world coordinates
};

struct ViewTransform {
    // Maps offsets from the view's origin to the eye's axes; the eye looks along -z. The eye of a parallel view is
    // placed in front of all bounds; its distance does not change the picture.
    glm::dmat4 view;
    glm::dmat4 projection; // to clip space, z from -1 to 1 between the nearest and farthest point of the bounds
    double scale = 1;      // 1 / the bounds' diagonal
};

// Returns the matrices of a viewpoint. Throws Error when a number of the camera is not finite or out of range. A camera
// at its target, or with `up` along its line of sight, is valid.
[[nodiscard]] ViewTransform view_transform(const Viewpoint& seen);

// Returns a camera that shows the whole box with a small margin, from a fixed direction. parallel_height is set as
// well.
[[nodiscard]] Camera default_camera(Vec3d bounds_min, Vec3d bounds_max, double aspect,
                                    double fov_degrees = Camera{}.fov_degrees);

} // namespace ciel::annotations
