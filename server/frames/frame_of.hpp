// Makes the renderer's frame of a scene: primitives, volumes, camera, lighting and background.
#pragma once

#include "geometry/geometry.hpp"
#include "render/renderer.hpp"
#include "scene/checked_scene.hpp"

namespace server::frames {

// Returns a frame without annotations. `geometry` must outlive the frame. The default camera of a scene without camera
// leaves room for annotations (annotations/make_room.hpp). Throws Error if the font is not installed.
[[nodiscard]] render::Frame frame_of(const geometry::Geometry& geometry, const scene::CheckedScene& checked, int width,
                                     int height, int samples);

} // namespace server::frames
