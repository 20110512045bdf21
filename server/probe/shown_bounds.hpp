// What a view of "everything" frames: the box around what is left of the mesh, or around what is drawn.
#pragma once

#include "geometry/scene_geometry.hpp"
#include "geometry/view_size.hpp"

#include <optional>

namespace ciel::probe {

// Of all visible layers together. A layer with a threshold counts with the cells that it keeps, any other with the
// whole box: an iso-surface or a plane that moves moves no view. Outlines count where nothing else is shown. Planes cut
// all of them. The mesh's own bounds where nothing is left. Reads all points of layers with a threshold.
[[nodiscard]] geometry::BoundingBox shown_bounds(const geometry::Geometry& geometry, const scene::Scene& scene);

// Of what the visible layers draw, cut by the planes. Where a part of the boundary is drawn (patches, or cells within a
// threshold), it is that part and the iso-surfaces: a slice through the far field would make a body in it a speck.
// Volumes count with the whole box, outlines where nothing else is drawn. Where nothing is drawn it is shown_bounds.
// Reads all points that are drawn.
[[nodiscard]] geometry::BoundingBox drawn_bounds(const geometry::Geometry& geometry, const scene::Scene& scene);

// The same of the points alone that a picture of this size shows, hidden or not; none where there are none. An outline
// never counts, nor does a volume.
[[nodiscard]] std::optional<geometry::BoundingBox> bounds_in_view(const geometry::Geometry& geometry,
                                                                  const scene::Scene& scene, geometry::ViewSize size);

} // namespace ciel::probe
