// The programs of ambient_occlusion.hpp, and the surfaces' lookup of their result. Lengths are in units of the radius.
#pragma once

#include "render/context/shader_program.hpp"

namespace ciel::render {

// Writes the share of the light, the depth, and the change of depth per texel along x and y.
[[nodiscard]] ShaderProgram make_occlusion_program(const Gl& gl);
// Writes the mean share of 4 x 4 texels of the same surface, and the depth.
[[nodiscard]] ShaderProgram make_even_light_program(const Gl& gl);

// GLSL for a fragment shader: light_from_everywhere(depth) returns the factor for a lit color at that depth.
// The caller sets its uniforms.
extern const char* const occluded_glsl;

} // namespace ciel::render
