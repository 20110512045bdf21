#pragma once

#include "geometry/geometry.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace ciel::frames {

// Returns a frame without annotations. The frame does not own its arrays; `geometry` must outlive the frame. `width`,
// `height`: pixels. `samples`: samples per pixel. If the scene has no camera, the default camera is far enough away to
// leave room for annotations (annotations/make_room.hpp). Throws Error if the font is not installed.
[[nodiscard]] render::Frame frame_of(const geometry::Geometry& geometry, const scene::Scene& scene, int width,
                                     int height, int samples);

} // namespace ciel::frames
