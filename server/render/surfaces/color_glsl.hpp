// color_scale.hpp's rule in GLSL 3.30: `vec3 scale_color(float value, float row)`, and `base_color`, which returns
// the solid color for a negative row. Needs the two textures that ColorScales binds.
#pragma once

namespace ciel::render {

extern const char* const color_scale_glsl;

} // namespace ciel::render
