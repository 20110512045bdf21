// Composites a picture with one ray per pixel onto a multisampled target. In a pixel on an outline of opaque surfaces,
// only some samples are on the surface. A sample takes the color of the nearest pixel whose ray hits or misses the
// surface in the same way.
#pragma once

#include "render/context/shader_program.hpp"

#include <functional>

namespace server::render {

// Returns the GLSL of seen_from(), which returns the position in pixels from which a fragment takes its color. If
// `of_samples`, this is the nearest pixel whose ray hits or misses the surface as the samples do. Otherwise it is the
// position of the fragment.
[[nodiscard]] const char* seen_from_glsl(bool of_samples);

struct PerSample {
    GLuint opaque = 0; // window depths at which the picture's rays end; same size as the picture
    int unit = 0;      // texture unit for `opaque`
};
// Calls `draw` for samples behind outlines and pixels without outlines, then for samples in front of outlines.
// `program` must be in use, and the target bound. Writes no depth, and leaves the depth test enabled.
void draw_per_sample(const Gl& gl, const ShaderProgram& program, const PerSample& what,
                     const std::function<void()>& draw);

} // namespace server::render
