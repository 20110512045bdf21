// Geometry -> what the renderer draws.
#pragma once

#include "geometry/geometry.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace ciel::frames {

// Borrows from `geometry`. width, height: pixels. samples: of a pixel. Without a camera in the scene it looks from as
// far as what is written over pictures needs (annotations/make_room.hpp), though it carries none of it. Throws Error
// when the font is not installed.
[[nodiscard]] render::Frame frame_of(const geometry::Geometry& geometry, const scene::Scene& scene, int width,
                                     int height, int samples);

} // namespace ciel::frames
