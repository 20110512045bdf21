// Why nothing is seen of a layer that is switched on.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

// Of the visible layers that have something to show at all (outlines and clips have not), those of which no picture of
// `geometry` shows anything, whatever the camera, in their order. Those that `geometry.empty` holds already are left
// out. Reads `geometry`'s shapes only where planes cut them: to the first point that stays.
[[nodiscard]] std::vector<EmptyLayer> empty_layers(const Geometry& geometry, const scene::Scene& scene,
                                                   const store::Dataset& dataset);

} // namespace ciel::geometry
