// The full-screen programs of depth_peeling.hpp. The programs of surfaces, lines and points are in shaders.hpp.
#pragma once

#include "render/context/shader_program.hpp"

namespace server::render {

// Copies opaque depths to layers with 2 x 2 pixels per picture pixel. All 4 layer pixels of a picture pixel are then on
// the same side of an outline: outliers get about the depth at the center of the picture pixel.
[[nodiscard]] ShaderProgram make_kept_to_outlines_program(const Gl& gl);
// Writes opaque depth at the layers' resolution, or 0 (nearest) where the nearer layers hide everything.
[[nodiscard]] ShaderProgram make_depth_copy_program(const Gl& gl);
// Writes one layer as seen through the volumes in front of it, to blend it behind the nearer layers.
[[nodiscard]] ShaderProgram make_layer_sum_program(const Gl& gl);
// Composites all layers and volumes. Alpha is their transmittance. `per_sample`: for draw_per_sample().
[[nodiscard]] ShaderProgram make_layers_picture_program(const Gl& gl, bool per_sample);

} // namespace server::render
