// Converts geometry to a render::Frame.
#pragma once

#include "geometry/geometry.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace ciel::frames {

// Returns a frame without annotations that borrows from `geometry`. width, height: pixels. samples: per pixel. If the
// scene has no camera, the default camera is as far away as the annotations need (annotations/make_room.hpp). Throws
// Error when the font is not installed.
[[nodiscard]] render::Frame frame_of(const geometry::Geometry& geometry, const scene::Scene& scene, int width,
                                     int height, int samples);

} // namespace ciel::frames
