// Reasons why a visible layer shows nothing.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

// Returns the visible layers of which `geometry` shows nothing from any camera, in layer order. Outlines, clips and
// layers in `geometry.empty` are left out. Reads shapes only if planes cut them, and each up
// to the first point that is kept.
[[nodiscard]] std::vector<EmptyLayer> empty_layers(const Geometry& geometry, const scene::Scene& scene,
                                                   const store::Dataset& dataset);

} // namespace ciel::geometry
