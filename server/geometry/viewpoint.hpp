// From where a scene is looked at.
#pragma once

#include "annotations/camera.hpp"
#include "geometry/geometry.hpp"
#include "scene/scene.hpp"

#include <optional>

namespace ciel::geometry {

// The scene's camera, or the default view of the bounds.
[[nodiscard]] annotations::Camera camera_of(const Geometry& geometry, const scene::Scene& scene, double aspect);
// Of the whole of the bounds, or of a box in them, from as far as what is written over pictures of that size needs
// (annotations/make_room.hpp). width, height: pixels. Throws Error when the font is not installed.
[[nodiscard]] annotations::Camera default_view(const Geometry& geometry, const scene::Scene& scene, int width,
                                               int height, double fov_degrees = annotations::Camera{}.fov_degrees,
                                               bool parallel = false, const std::optional<BoundingBox>& of = {});
// Of a picture of that size: the scene's camera, or default_view.
[[nodiscard]] annotations::Viewpoint viewpoint_of(const Geometry& geometry, const scene::Scene& scene, int width,
                                                  int height);

} // namespace ciel::geometry
