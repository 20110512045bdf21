// Geometry -> the polygon batches of protocol/frame.md, kind 2.
#pragma once

#include "session/scene_geometry.hpp"
#include "session/view.hpp"
#include "wire/frame_header.hpp"

namespace ciel::session {

// Whole messages, header first; one without vertices when there is nothing to see. Fills in the header's encoding time,
// sizes and flags. `pixel_ratio`: of the view.
[[nodiscard]] std::vector<std::vector<std::uint8_t>> geometry_messages(wire::FrameHeader& header,
                                                                       const Geometry& geometry, double pixel_ratio);
// Equal for two geometries exactly when their messages carry the same polygons and colours.
[[nodiscard]] ContentKey content_of(const Geometry& geometry);

} // namespace ciel::session
