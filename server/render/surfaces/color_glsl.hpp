// The rule of color_scale.hpp in GLSL 3.30. `vec3 scale_color(float value, float row)` returns the color of a value.
// `base_color` returns the solid color for a negative row. Needs the two textures that ColorScales binds.
#pragma once

namespace ciel::render {

extern const char* const color_scale_glsl;

} // namespace ciel::render
