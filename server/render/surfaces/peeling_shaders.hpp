// The full-screen programs of depth_peeling.hpp. The programs of surfaces, lines and points are in shaders.hpp.
#pragma once

#include "render/context/shader_program.hpp"

namespace ciel::render {

// Writes opaque depth at the resolution of the peeled layers, 2 x 2 layer pixels per picture pixel. A layer pixel that
// an outline separates from the middle of its picture pixel gets about the depth of that middle.
[[nodiscard]] ShaderProgram make_kept_to_outlines_program(const Gl& gl);
// Writes opaque depth at the layers' resolution; 0 (nearest) where the nearer layers hide everything behind them.
[[nodiscard]] ShaderProgram make_depth_copy_program(const Gl& gl);
// Writes one layer seen through the volumes in front of it, to be blended behind the nearer layers.
[[nodiscard]] ShaderProgram make_layer_sum_program(const Gl& gl);
// Composites all layers and volumes onto the picture; alpha: the share of the opaque picture that shows through.
// per_sample is for draw_per_sample().
[[nodiscard]] ShaderProgram make_layers_picture_program(const Gl& gl, bool per_sample);

} // namespace ciel::render
