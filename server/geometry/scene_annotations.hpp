// What is written over a picture of a scene.
#pragma once

#include "annotations/annotations.hpp"
#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

// One legend for each array, map and range that visible layers are colored by, in drawing order;
// where two are of one array, the layers tell them apart. Layers of which nothing is seen have none, but for
// `all_layers`: a view that makes room for legends must not jump while a threshold that is moved keeps nothing.
enum class LegendsOf { what_is_seen, all_layers };
[[nodiscard]] annotations::Annotations annotations_of(const Geometry& geometry, const scene::Scene& scene,
                                                      LegendsOf legends = LegendsOf::what_is_seen);

} // namespace ciel::geometry
