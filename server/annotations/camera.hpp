// Computes the matrices of a view in double, because floats have too few digits far from the origin.
#pragma once

#include "ciel/types.hpp"

#include <glm/mat4x4.hpp>

namespace server::annotations {

// A camera to draw with. No member is optional, unlike in scene::Camera, which is a part of the scene document.
struct ViewCamera {
    ciel::Vec3d position{}, target{}, up{0, 0, 1}; // world coordinates
    double fov_degrees = 30;
    bool parallel = false;
    double parallel_height = 1; // of a parallel view: world units from the lower to the upper edge of the picture
};

// Returns whether all vectors are finite, the field of view lies between 0 and 180 degrees, and the height of a
// parallel view is positive.
[[nodiscard]] bool is_usable(const ViewCamera& camera);

struct Viewpoint {
    int width = 0, height = 0; // pixels
    ciel::Vec3d origin{};      // offsets are world coordinates minus this point
    ViewCamera camera;
    ciel::Vec3d bounds_min{}, bounds_max{}; // bounding box of the scene in world coordinates; sets the depth range
};

struct ViewTransform {
    // Maps offsets (Viewpoint::origin) to eye space, in which the eye looks along -z. In a parallel view, the eye is
    // moved back until it is in front of the whole bounding box. This does not change the picture.
    glm::dmat4 view;
    glm::dmat4 projection; // maps eye space to clip space; the near and far planes depend on the bounds
    double scale = 1;      // 1 / diagonal of the bounds; 1 if the diagonal is 0 or not finite
};

// Throws Error unless is_usable(seen.camera). The target may equal the position, and `up` may be parallel to the view.
[[nodiscard]] ViewTransform view_transform(const Viewpoint& seen);

// Returns a camera that shows the whole box with a small margin, also in a parallel view. `aspect`: width / height.
[[nodiscard]] ViewCamera default_camera(ciel::Vec3d bounds_min, ciel::Vec3d bounds_max, double aspect,
                                        double fov_degrees = ViewCamera{}.fov_degrees);

} // namespace server::annotations
