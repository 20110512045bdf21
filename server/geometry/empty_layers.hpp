// Reasons why a visible layer shows nothing.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

// Returns the visible layers that show nothing in `geometry`, whatever the camera is, each with the reason. The order
// is the order of the layers. Leaves out outlines, clip layers and layers in `geometry.empty`. If there are clip
// planes, reads each shape up to the first point that the planes keep.
[[nodiscard]] std::vector<EmptyLayer> empty_layers(const Geometry& geometry, const scene::Scene& scene,
                                                   const store::Dataset& dataset);

} // namespace ciel::geometry
