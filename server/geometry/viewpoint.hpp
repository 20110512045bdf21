// Camera of a scene.
#pragma once

#include "annotations/camera.hpp"
#include "geometry/geometry.hpp"
#include "scene/scene.hpp"

#include <optional>

namespace ciel::geometry {

// Returns the scene's camera, or annotations::default_camera of the bounds.
[[nodiscard]] annotations::Camera camera_of(const Geometry& geometry, const scene::Scene& scene, double aspect);
// Returns a camera that shows the bounds, or the box `of`, and leaves room for the annotations in a picture of this
// size (annotations/make_room.hpp). width, height: pixels. Throws Error when the font is not installed.
[[nodiscard]] annotations::Camera default_view(const Geometry& geometry, const scene::Scene& scene, int width,
                                               int height, double fov_degrees = annotations::Camera{}.fov_degrees,
                                               bool parallel = false, const std::optional<BoundingBox>& of = {});
// The scene's camera, or default_view if the scene has no camera. Throws like default_view.
[[nodiscard]] annotations::Viewpoint viewpoint_of(const Geometry& geometry, const scene::Scene& scene, int width,
                                                  int height);

} // namespace ciel::geometry
