// From a camera and bounds to matrices, in double: far from the origin float has nothing left for the picture.
#pragma once

#include "render/renderer.hpp"

#include <glm/mat4x4.hpp>

namespace ciel::render {

struct ViewTransform {
    glm::dmat4 view;       // offsets from the frame's origin -> the eye's axes, looking along -z
    glm::dmat4 projection; // -> clip space, z from -1 to 1 between the nearest and farthest point of the bounds
    double scale = 1;      // 1 / the bounds' diagonal
};

// Throws Error when the camera is not made of finite numbers. A camera at its target, or with `up` along its view,
// still gives a picture.
[[nodiscard]] ViewTransform view_transform(const Frame& frame);

} // namespace ciel::render
