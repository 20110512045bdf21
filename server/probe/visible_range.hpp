// Range of the values in view. A color range can be narrowed to this range, so that the visible part has all colors.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace ciel::probe {

// Returns the smallest and largest finite scalar at the vertices of these layers; nothing if there is none. A volume
// has the vertices of its slices and boundary. `aspect`: width / height of the view. If it is given, a vertex counts
// only inside the view's pyramid and between the clip planes, even if it is hidden. `of_contours`: true for the contour
// lines on the layers only, false for everything else.
[[nodiscard]] std::optional<std::array<double, 2>> visible_range(const geometry::Geometry& geometry,
                                                                 const scene::Scene& scene,
                                                                 const std::vector<std::string>& layers,
                                                                 std::optional<double> aspect, bool of_contours);

} // namespace ciel::probe
