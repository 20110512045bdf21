// Computes the texels of a color scale in the texture scale_rules of protocol/shading/color_scale.glsl. The web page
// runs the same code (server/page).
#pragma once

#include "color/color_scale.hpp"

namespace server::color {

struct ScaleRules {
    // Subtract this from values before they become floats, so that values of a small range far from 0 keep their
    // digits.
    float origin = 0;
    std::array<std::array<float, 4>, 5> texels{}; // RGBA; all are finite, because shaders need not support infinity
};

[[nodiscard]] float origin_of(const ColorScale& scale);
[[nodiscard]] ScaleRules scale_rules(const ColorScale& scale);

} // namespace server::color
