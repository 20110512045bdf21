// The lighting formulas that the server and the web page share.
#pragma once

namespace ciel::render {

// GLSL for a fragment shader: lit_surface() and lit_ball() shade a color. The caller sets the uniform `lights` to the
// strengths of ambient light, headlight and key light. The web page is built from the same text.
extern const char* const lighting_glsl;

} // namespace ciel::render
