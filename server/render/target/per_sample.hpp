// Puts a picture that has one ray a pixel on a target of several samples, without the steps that it has where an opaque
// surface ends: there the pixel's ray met the surface or went past it, but some of its samples did the other. Each
// sample takes the color of the nearest pixel whose ray did the same.
#pragma once

#include "render/context/shader_program.hpp"

#include <functional>

namespace ciel::render {

// Before a fragment program's own text, which asks seen_from() for the place in the picture, in pixels, that it takes
// its color from: its own, or of a program that draw_per_sample() draws with that of the nearest fitting pixel.
[[nodiscard]] const char* seen_from_glsl(bool of_samples);

struct PerSample {
    GLuint opaque = 0; // window depths where the picture's rays end, of its size
    int unit = 0;      // that it is bound to
};
// Draws twice with the program, which is in use, onto the target, which is bound: with the depth of its samples as it
// is. Leaves the depth test on.
void draw_per_sample(const Gl& gl, const ShaderProgram& program, const PerSample& what,
                     const std::function<void()>& draw);

} // namespace ciel::render
