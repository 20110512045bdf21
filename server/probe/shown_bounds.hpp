// Boxes that a camera is fitted to, to show "everything": around the remaining mesh, or around the drawn geometry.
#pragma once

#include "geometry/scene_geometry.hpp"
#include "geometry/view_size.hpp"

#include <optional>

namespace ciel::probe {

// Returns the box of all visible layers together, cut by the clip planes. A layer with a threshold counts with the
// cells that it keeps. Any other counts with the whole box: a moving iso-surface or plane must not move the view.
// Outlines count if nothing else is shown. Returns the mesh's bounds if nothing is left. Reads all points of layers
// with thresholds.
[[nodiscard]] geometry::BoundingBox shown_bounds(const geometry::Geometry& geometry, const scene::Scene& scene);

// Returns the box of the drawn geometry, cut by the clip planes. If a part of the boundary is drawn (patches, or cells
// within a threshold), only that part and iso-surfaces count: a slice through the far field would make a body a speck.
// Volumes count with the whole box. If nothing is drawn but outlines, returns shown_bounds. Reads all drawn points.
[[nodiscard]] geometry::BoundingBox drawn_bounds(const geometry::Geometry& geometry, const scene::Scene& scene);

// Returns the box of the drawn points in a picture of this size, hidden or not; nothing if there are none. If a part of
// the boundary is in view, only that part counts. Outlines and volumes do not count.
[[nodiscard]] std::optional<geometry::BoundingBox> bounds_in_view(const geometry::Geometry& geometry,
                                                                  const scene::Scene& scene, geometry::ViewSize size);

} // namespace ciel::probe
