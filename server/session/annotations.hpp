// What is written over a picture of a scene.
#pragma once

#include "session/scene_geometry.hpp"

namespace ciel::session {

// One legend for each array, map and range that visible layers are coloured by, in drawing order;
// where two are of one array, the layers tell them apart. Layers of which nothing is seen have none, but for
// `all_layers`: a view that makes room for legends must not jump while a threshold that is moved keeps nothing.
enum class LegendsOf { what_is_seen, all_layers };
[[nodiscard]] render::Annotations annotations_of(const Geometry& geometry, const scene::Scene& scene,
                                                 LegendsOf legends = LegendsOf::what_is_seen);

} // namespace ciel::session
