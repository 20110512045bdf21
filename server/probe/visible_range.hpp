// The range of the values in view. If a color range is set to this range, the visible part has all colors.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace server::probe {

// Returns the least and greatest finite scalar at the vertices of these layers; nothing if there is none. A volume has
// the vertices of its slices and its boundary. `aspect`: width / height of the view. If it is given, only vertices that
// are inside the view and kept by the clip planes are used, including hidden vertices. `of_contours`: if true, uses
// only the contour lines on the layers; if false, everything else.
[[nodiscard]] std::optional<std::array<double, 2>> visible_range(const geometry::Geometry& geometry,
                                                                 const scene::CheckedScene& checked,
                                                                 const std::vector<std::string>& layers,
                                                                 std::optional<double> aspect, bool of_contours);

} // namespace server::probe
