// The lighting formulas that the server and the page share.
#pragma once

namespace ciel::render {

// GLSL, for a fragment shader: `lights` to be set to the three strengths, and lit_surface() and lit_ball(), which
// brighten a color. The page is built from the same.
extern const char* const lighting_glsl;

} // namespace ciel::render
