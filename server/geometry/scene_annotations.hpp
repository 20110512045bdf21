// Annotations of a picture of a scene.
#pragma once

#include "annotations/annotations.hpp"
#include "geometry/scene_geometry.hpp"

namespace server::geometry {

// The result has one legend for each array and color scale that visible layers use, in drawing order. Legends of the
// same array name their layers. A layer that shows nothing has a legend only with `all_layers`. The default camera uses
// `all_layers`, so that it does not jump while a changing threshold keeps no cell.
enum class LegendsOf { what_is_seen, all_layers };
[[nodiscard]] annotations::Annotations annotations_of(const Geometry& geometry, const scene::CheckedScene& checked,
                                                      LegendsOf legends = LegendsOf::what_is_seen);

} // namespace server::geometry
