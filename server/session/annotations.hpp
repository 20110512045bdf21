// What is written over a picture of a scene.
#pragma once

#include "session/scene_geometry.hpp"

namespace ciel::session {

// One legend for each array, map and range that visible layers are coloured by, in drawing order;
// where two are of one array, the layers tell them apart.
[[nodiscard]] render::Annotations annotations_of(const Geometry& geometry, const scene::Scene& scene);

} // namespace ciel::session
