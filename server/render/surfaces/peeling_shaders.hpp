// The full-screen programs of depth_peeling.hpp. The programs of surfaces, lines and points are in shaders.hpp.
#pragma once

#include "render/context/shader_program.hpp"

namespace ciel::render {

// Writes opaque depth at twice the picture's resolution; across an outline, the depth near the pixel's middle.
[[nodiscard]] ShaderProgram make_kept_to_outlines_program(const Gl& gl);
// Writes opaque depth at the layers' resolution; 0, the nearest, where the nearer layers hide what is behind them.
[[nodiscard]] ShaderProgram make_depth_copy_program(const Gl& gl);
// Writes one layer seen through the volumes in front of it, to be blended behind the nearer layers.
[[nodiscard]] ShaderProgram make_layer_sum_program(const Gl& gl);
// Composites all layers and volumes onto the picture; alpha: the share of the opaque picture that shows through.
// per_sample is for draw_per_sample().
[[nodiscard]] ShaderProgram make_layers_picture_program(const Gl& gl, bool per_sample);

} // namespace ciel::render
