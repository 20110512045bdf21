// The full-screen programs of depth_peeling.hpp. The programs of surfaces, lines and points are in shaders.hpp.
#pragma once

#include "render/context/shader_program.hpp"

namespace ciel::render {

// The program copies the depths of the opaque surfaces to layers that have 2 x 2 pixels for each picture pixel.
// Afterwards, all 4 layer pixels of a picture pixel lie on the same side of an outline: if the depth of a layer pixel
// differs strongly from the depth at the center of the picture pixel, the program writes about the depth at the center.
[[nodiscard]] ShaderProgram make_kept_to_outlines_program(const Gl& gl);
// The program writes opaque depth at the resolution of the layers, or 0 (nearest) where the nearer layers hide
// everything.
[[nodiscard]] ShaderProgram make_depth_copy_program(const Gl& gl);
// The program writes one layer as seen through the volumes in front of it. The result is blended behind the nearer
// layers.
[[nodiscard]] ShaderProgram make_layer_sum_program(const Gl& gl);
// The program composites all layers and volumes onto the picture. Alpha is their transmittance, by which the opaque
// picture is multiplied. `per_sample`: the program is for draw_per_sample().
[[nodiscard]] ShaderProgram make_layers_picture_program(const Gl& gl, bool per_sample);

} // namespace ciel::render
