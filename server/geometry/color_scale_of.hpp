// The color scale of a scene's coloring.
#pragma once

#include "color/color_scale.hpp"
#include "scene/scene.hpp"

#include <nlohmann/json_fwd.hpp>

namespace server::geometry {

// `data_range`: range of the array at the shown step.
[[nodiscard]] color::ColorScale color_scale_of(const scene::Coloring& coloring, std::array<double, 2> data_range);
// See color::is_shown_by.
[[nodiscard]] bool is_shown_by(const scene::Coloring& coloring, std::array<double, 2> data_range);

// Returns the color scale as in a scene's coloring, without map, range and members with default values.
[[nodiscard]] nlohmann::json json_of(const color::ColorScale& scale);

} // namespace server::geometry
