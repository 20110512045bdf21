// Composites a picture with one ray per pixel onto a multisampled target, with smooth outlines of opaque surfaces. In a
// pixel on an outline, some samples are on the surface and some are not, but the ray of the pixel only hits or misses.
// A sample on the surface takes the color of the nearest pixel whose ray hits the surface. Any other sample takes the
// color of the nearest pixel whose ray misses the surface.
#pragma once

#include "render/context/shader_program.hpp"

#include <functional>

namespace ciel::render {

// Returns GLSL to put before a fragment shader. Its function seen_from() returns the position in the picture, in
// pixels, from which the fragment takes its color. If `of_samples`, which draw_per_sample() needs, this is the nearest
// pixel whose ray hits or misses the surface in the same way as the samples being drawn. Otherwise it is the position
// of the fragment.
[[nodiscard]] const char* seen_from_glsl(bool of_samples);

struct PerSample {
    GLuint opaque = 0; // window depths at which the picture's rays end; same size as the picture
    int unit = 0;      // texture unit for `opaque`
};
// Calls `draw` twice: for samples behind outlines and pixels without outlines, then for samples in front of outlines.
// `program` must be in use, and the target must be bound. Tests the depth of the target's samples, but does not write
// depth. Leaves the depth test enabled.
void draw_per_sample(const Gl& gl, const ShaderProgram& program, const PerSample& what,
                     const std::function<void()>& draw);

} // namespace ciel::render
