// Camera of a scene.
#pragma once

#include "annotations/camera.hpp"
#include "geometry/geometry.hpp"
#include "scene/checked_scene.hpp"

#include <optional>

namespace server::geometry {

// Returns the scene's camera `given`, or annotations::default_camera of the bounds if the scene has none.
[[nodiscard]] annotations::ViewCamera camera_of(const Geometry& geometry, const std::optional<scene::Camera>& given,
                                                double aspect);
// Returns a camera that shows the bounds, or the box `of`, and leaves room for the annotations in a picture of this
// size (annotations/make_room.hpp). width, height: pixels. Throws Error when the font is not installed.
[[nodiscard]] annotations::ViewCamera default_view(const Geometry& geometry, const scene::CheckedScene& checked,
                                                   int width, int height,
                                                   double fov_degrees = annotations::ViewCamera{}.fov_degrees,
                                                   bool parallel = false, const std::optional<BoundingBox>& of = {});
// Returns a viewpoint with the scene's camera, or with default_view if the scene has no camera. Throws like
// default_view.
[[nodiscard]] annotations::Viewpoint viewpoint_of(const Geometry& geometry, const scene::CheckedScene& checked,
                                                  int width, int height);

} // namespace server::geometry
