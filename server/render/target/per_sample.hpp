// Composites a picture with one ray per pixel onto a multisampled target, with smooth outlines of opaque surfaces.
// At an outline the ray of a pixel hits or misses the surface, and some samples do the opposite. Each sample takes the
// color of the nearest pixel whose ray did the same as the sample.
#pragma once

#include "render/context/shader_program.hpp"

#include <functional>

namespace ciel::render {

// Returns GLSL to put before a fragment shader. Its seen_from() returns the place in the picture, in pixels, to take
// the color from. If `of_samples`, as draw_per_sample() needs, this is the nearest pixel whose ray hit or missed the
// surface as the samples do. Otherwise it is the fragment's own place.
[[nodiscard]] const char* seen_from_glsl(bool of_samples);

struct PerSample {
    GLuint opaque = 0; // window depths at which the picture's rays end; same size as the picture
    int unit = 0;      // texture unit for `opaque`
};
// Calls `draw` for samples behind outlines, then for samples in front. The caller has `program` in use and the target
// bound. Tests the depth of the target's samples, but does not write it. Leaves the depth test on.
void draw_per_sample(const Gl& gl, const ShaderProgram& program, const PerSample& what,
                     const std::function<void()>& draw);

} // namespace ciel::render
