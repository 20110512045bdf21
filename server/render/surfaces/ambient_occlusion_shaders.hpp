// The programs of ambient_occlusion.hpp, and GLSL with which surfaces look up the result. Lengths are in units of
// Occlusion::radius.
#pragma once

#include "render/context/shader_program.hpp"

namespace server::render {

// The program writes R: share of the light, G: depth, BA: change of depth per texel along x and y.
[[nodiscard]] ShaderProgram make_occlusion_program(const Gl& gl);
// The program writes R: mean share of the light over 4 x 4 texels of the same surface, G: depth.
[[nodiscard]] ShaderProgram make_even_light_program(const Gl& gl);

// light_from_everywhere(depth) returns a factor for a lit color. The caller sets the uniforms.
extern const char* const occluded_glsl;

} // namespace server::render
