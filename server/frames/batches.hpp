// Geometry -> the polygon batches of protocol/frame.md, kind 2.
#pragma once

#include "geometry/geometry.hpp"
#include "wire/batches/geometry_batch.hpp"
#include "wire/frame_header.hpp"

namespace ciel::frames {

// What identifies the content of a geometry frame: a camera change alone sends none.
using ContentKey = std::string;

// Whole messages, header first; one without vertices when there is nothing to see; and what they hold. Fills in the
// header's encoding time, sizes and flags. `pixel_ratio`: of the view. `grid`: the step of its grid (pixel_grid.hpp).
[[nodiscard]] wire::EncodedGeometry geometry_messages(wire::FrameHeader& header, const geometry::Geometry& geometry,
                                                      double pixel_ratio, double grid, const wire::HeldArrays& held);
// Equal for two geometries exactly when their messages carry the same polygons and colors, on one grid.
[[nodiscard]] ContentKey content_of(const geometry::Geometry& geometry);

} // namespace ciel::frames
