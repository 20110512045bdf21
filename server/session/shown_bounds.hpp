// The box around what clip planes and thresholds leave of the mesh: what a view of "everything" frames.
#pragma once

#include "session/scene_geometry.hpp"

namespace ciel::session {

// Of all visible layers together. A layer with a threshold counts with the cells that it keeps, any other with the
// whole box: an iso-surface or a plane that moves moves no view. Outlines count where nothing else is shown. Planes cut
// all of them. The mesh's own bounds where nothing is left. Reads all points of layers with a threshold.
[[nodiscard]] BoundingBox shown_bounds(const Geometry& geometry, const scene::Scene& scene);

} // namespace ciel::session
