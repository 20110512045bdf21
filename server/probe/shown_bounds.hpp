// Boxes to which a camera is fitted.
#pragma once

#include "geometry/scene_geometry.hpp"
#include "geometry/view_size.hpp"

#include <optional>

namespace server::probe {

// Returns the box of all visible layers together, cut by the clip planes. If every visible layer has a threshold, it is
// the box of the kept cells. Otherwise it is the box of the mesh, because the view must not move when an iso-surface or
// a plane moves. Ignores outlines. Returns the bounds of the mesh if nothing is left.
[[nodiscard]] geometry::BoundingBox shown_bounds(const geometry::Geometry& geometry,
                                                 const scene::CheckedScene& checked);

// Returns the box of the drawn geometry, cut by the clip planes. If some layers show only patches or the cells of a
// threshold, it is the box of these layers and iso-surfaces: with a slice through the far field, a body would be too
// small to see. A volume has the box of the mesh. If only outlines are drawn, returns shown_bounds.
[[nodiscard]] geometry::BoundingBox drawn_bounds(const geometry::Geometry& geometry,
                                                 const scene::CheckedScene& checked);

// Returns the box of the drawn points that are inside a picture of this size, including points that are hidden. Returns
// nothing if there are no such points. If layers that show only a part of the mesh are in view, the box is around the
// points of these layers only. Outlines and volumes are ignored.
[[nodiscard]] std::optional<geometry::BoundingBox>
bounds_in_view(const geometry::Geometry& geometry, const scene::CheckedScene& checked, geometry::ViewSize size);

} // namespace server::probe
