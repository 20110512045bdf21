// Reasons why a visible layer shows nothing.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace server::geometry {

// Returns the visible layers that show nothing, whatever the camera is, in layer order, each with the reason. Leaves
// out outlines, clip layers and layers in `geometry.empty`. With clip planes, reads points of each shape.
[[nodiscard]] std::vector<EmptyLayer> empty_layers(const Geometry& geometry, const scene::CheckedScene& checked);

} // namespace server::geometry
