// From a camera and bounds to matrices, in double: far from the origin float has nothing left for the picture.
#pragma once

#include "render/renderer.hpp"

#include <glm/mat4x4.hpp>

namespace ciel::render {

struct ViewTransform {
    // Offsets from the frame's origin -> the eye's axes, looking along -z. The eye of a parallel view, whose place
    // along its rays changes nothing, is before all of the bounds.
    glm::dmat4 view;
    glm::dmat4 projection; // -> clip space, z from -1 to 1 between the nearest and farthest point of the bounds
    double scale = 1;      // 1 / the bounds' diagonal
};

// Throws Error when the camera is not made of finite numbers. A camera at its target, or with `up` along its view,
// still gives a picture.
[[nodiscard]] ViewTransform view_transform(const Frame& frame);

} // namespace ciel::render
