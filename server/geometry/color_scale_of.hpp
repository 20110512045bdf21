// The color scale of a scene's coloring. The browser has the same rules (webclient/src/model/color_range.ts).
#pragma once

#include "color/color_scale.hpp"
#include "scene/scene.hpp"

#include <nlohmann/json_fwd.hpp>

namespace ciel::geometry {

// Number of decades below the maximum that a logarithmic scale covers if the minimum is not above zero.
inline constexpr double log_decades = 6;

// `data_range`: range of the array at the shown step.
[[nodiscard]] color::ColorScale color_scale_of(const scene::Coloring& coloring, std::array<double, 2> data_range);
// Returns false if a logarithmic scale takes its range from data without a value above zero.
[[nodiscard]] bool is_shown_by(const scene::Coloring& coloring, std::array<double, 2> data_range);

// As in a scene's coloring. Leaves out map, range and members with default values.
[[nodiscard]] nlohmann::json json_of(const color::ColorScale& scale);

} // namespace ciel::geometry
