// The programs of depth_peeling.hpp but the surfaces' own (shaders.hpp).
#pragma once

#include "render/context/shader_program.hpp"

namespace ciel::render {

// The depth of what is opaque, at twice the picture's resolution; beyond an outline that of the pixel's middle.
[[nodiscard]] ShaderProgram make_kept_to_outlines_program(const Gl& gl);
// The depth of what is opaque, at the layers' resolution; the nearest where nearer layers let nothing through.
[[nodiscard]] ShaderProgram make_depth_copy_program(const Gl& gl);
// One layer seen through the volumes in front of it; blended with what the nearer ones let through.
[[nodiscard]] ShaderProgram make_layer_sum_program(const Gl& gl);
// All layers and volumes onto the picture; alpha: the share of what is opaque that comes through. Per sample as
// draw_per_sample() does it.
[[nodiscard]] ShaderProgram make_layers_picture_program(const Gl& gl, bool per_sample);

} // namespace ciel::render
