// Converts geometry to the polygon batches of protocol/frame.md, kind 2.
#pragma once

#include "geometry/geometry.hpp"
#include "wire/batches/geometry_batch.hpp"
#include "wire/frame_header.hpp"

namespace server::frames {

// Identifies the content of a geometry frame. The camera is not included, so that turning the camera sends no frame.
using ContentKey = std::string;

// Returns the messages of a geometry frame, each with a header, and the ids of their arrays. An empty scene gives one
// message. Sets the encoding time, sizes and flags in `header`. `pixel_ratio`: factor on line widths. `grid`: grid step
// in length units (pixel_grid.hpp). `held`: arrays that are not sent, because the client has them.
[[nodiscard]] wire::EncodedGeometry geometry_messages(wire::FrameHeader& header, const geometry::Geometry& geometry,
                                                      double pixel_ratio, double grid, const wire::HeldArrays& held);
// Keys are equal if and only if the messages on the same grid have the same polygons and colors.
[[nodiscard]] ContentKey content_of(const geometry::Geometry& geometry);

} // namespace server::frames
