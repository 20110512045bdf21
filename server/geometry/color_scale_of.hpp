// From what a scene says of colors to the scale that is drawn: here the range of the data comes in. The browser's
// legend follows the same rules (webclient/src/scene/color_range.ts).
#pragma once

#include "color/color_scale.hpp"
#include "scene/scene.hpp"

#include <nlohmann/json_fwd.hpp>

namespace ciel::geometry {

// How far a logarithmic scale reaches down from the largest value of data that hold zero.
inline constexpr double log_decades = 6;

// data_range: the array's, at the shown step.
[[nodiscard]] color::ColorScale color_scale_of(const scene::Coloring& coloring, std::array<float, 2> data_range);
// False where data without a value above zero stand against a logarithmic scale that is to take their range.
[[nodiscard]] bool is_shown_by(const scene::Coloring& coloring, std::array<float, 2> data_range);

// The scale's members as in a scene's coloring, without map and range and without those that are the default.
[[nodiscard]] nlohmann::json json_of(const color::ColorScale& scale);

} // namespace ciel::geometry
