// Annotations of a picture of a scene.
#pragma once

#include "annotations/annotations.hpp"
#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

// Returns one legend per array, map and range that visible layers are colored by, in drawing order. Legends of one
// array are distinguished by their layers. Layers that show nothing have a legend only with `all_layers`: a view that
// leaves room for legends must not jump while a moving threshold keeps nothing.
enum class LegendsOf { what_is_seen, all_layers };
[[nodiscard]] annotations::Annotations annotations_of(const Geometry& geometry, const scene::Scene& scene,
                                                      LegendsOf legends = LegendsOf::what_is_seen);

} // namespace ciel::geometry
