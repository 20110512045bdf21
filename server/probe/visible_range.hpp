// The values that are in view: what a color range is narrowed to, so that what one looks at has all the colors.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace ciel::probe {

// Smallest and largest finite scalar at the vertices of these layers, of a volume at those of its slices and boundary;
// nothing where there is none. With an aspect, of those vertices that lie in the view's pyramid and that no clip plane
// takes away, whether something hides them or not. Of contour lines on the layers alone, or of all but those.
[[nodiscard]] std::optional<std::array<double, 2>> visible_range(const geometry::Geometry& geometry,
                                                                 const scene::Scene& scene,
                                                                 const std::vector<std::string>& layers,
                                                                 std::optional<double> aspect, bool of_contours);

} // namespace ciel::probe
