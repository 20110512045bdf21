// Converts geometry to the polygon batches of protocol/frame.md, kind 2.
#pragma once

#include "geometry/geometry.hpp"
#include "wire/batches/geometry_batch.hpp"
#include "wire/frame_header.hpp"

namespace ciel::frames {

// Identifies the content of a geometry frame. A change of the camera alone does not change the key, so that no frame is
// sent.
using ContentKey = std::string;

// Returns the messages of a geometry frame, and the ids of the arrays in these messages. Each message begins with a
// header. An empty scene gives one message without vertices. Sets the encoding time, sizes and flags in `header`.
// `pixel_ratio`: factor on line widths. `grid`: grid step in length units (pixel_grid.hpp). `held`: arrays that the
// client already has; these arrays are not sent.
[[nodiscard]] wire::EncodedGeometry geometry_messages(wire::FrameHeader& header, const geometry::Geometry& geometry,
                                                      double pixel_ratio, double grid, const wire::HeldArrays& held);
// Returns the key of a geometry. Two keys are equal if and only if the messages on the same grid have the same polygons
// and colors.
[[nodiscard]] ContentKey content_of(const geometry::Geometry& geometry);

} // namespace ciel::frames
