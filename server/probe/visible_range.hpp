// Range of the values in view. A color range is narrowed to it, so that the visible part has all the colors.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace ciel::probe {

// Returns the smallest and largest finite scalar at the vertices of these layers; nothing if there is none. A volume
// has the vertices of its slices and boundary. With an aspect, only vertices in the view's pyramid count that no clip
// plane removes, hidden or not. `of_contours`: only contour lines on the layers, else all but those.
[[nodiscard]] std::optional<std::array<double, 2>> visible_range(const geometry::Geometry& geometry,
                                                                 const scene::Scene& scene,
                                                                 const std::vector<std::string>& layers,
                                                                 std::optional<double> aspect, bool of_contours);

} // namespace ciel::probe
