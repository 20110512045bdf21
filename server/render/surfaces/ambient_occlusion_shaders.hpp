// The programs of ambient_occlusion.hpp, and how a surface looks up what they found. Lengths are in units of the
// radius.
#pragma once

#include "render/context/shader_program.hpp"

namespace ciel::render {

// Share of the light, depth, and how the depth changes from texel to texel along x and y.
[[nodiscard]] ShaderProgram make_occlusion_program(const Gl& gl);
// Mean of 4 x 4 texels of the same surface.
[[nodiscard]] ShaderProgram make_even_light_program(const Gl& gl);

// GLSL, for a fragment shader: light_from_everywhere(depth), of the fragment at that depth. Its uniforms are to be set.
extern const char* const occluded_glsl;

} // namespace ciel::render
