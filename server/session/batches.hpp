// Geometry -> the polygon batches of protocol/frame.md, kind 2.
#pragma once

#include "session/scene_geometry.hpp"
#include "session/view.hpp"
#include "wire/frame_header.hpp"
#include "wire/geometry_batch.hpp"

namespace ciel::session {

// Whole messages, header first; one without vertices when there is nothing to see; and what they hold. Fills in the
// header's encoding time, sizes and flags. `pixel_ratio`: of the view. `grid`: the step of its grid (pixel_grid.hpp).
[[nodiscard]] wire::EncodedGeometry geometry_messages(wire::FrameHeader& header, const Geometry& geometry,
                                                      double pixel_ratio, double grid, const wire::HeldParts& held);
// Equal for two geometries exactly when their messages carry the same polygons and colours, on one grid.
[[nodiscard]] ContentKey content_of(const Geometry& geometry);

} // namespace ciel::session
