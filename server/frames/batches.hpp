// Converts geometry to the polygon batches of protocol/frame.md, kind 2.
#pragma once

#include "geometry/geometry.hpp"
#include "wire/batches/geometry_batch.hpp"
#include "wire/frame_header.hpp"

namespace ciel::frames {

// Identifies the content of a geometry frame. A camera change alone does not change the key, so no frame is sent.
using ContentKey = std::string;

// Returns the messages of a geometry frame, each with its header first, and the ids of their arrays. An empty scene
// gives one message without vertices. Fills in the header's encoding time, sizes and flags. `pixel_ratio`: factor of
// line widths. `grid`: grid step in length units (pixel_grid.hpp). `held`: arrays that the client has; they are not
// sent.
[[nodiscard]] wire::EncodedGeometry geometry_messages(wire::FrameHeader& header, const geometry::Geometry& geometry,
                                                      double pixel_ratio, double grid, const wire::HeldArrays& held);
// Returns the key of a geometry. Two keys are equal exactly if the messages carry the same polygons and colors, given
// the same grid.
[[nodiscard]] ContentKey content_of(const geometry::Geometry& geometry);

} // namespace ciel::frames
