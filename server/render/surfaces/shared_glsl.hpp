// Shader text that the server and the web page share: protocol/shading/.
#pragma once

namespace ciel::render {

// GLSL for fragment shaders. base_color() returns the color of a value by the rules of color_scale.hpp, or a solid
// color. Needs the two textures that ColorScales binds.
extern const char* const color_scale_glsl;

// GLSL for fragment shaders: start_of_layer(), is_in_joint() and the constant `least`, for layers of depth peeling.
extern const char* const depth_layers_glsl;

// GLSL for fragment shaders: lit_surface() and lit_ball() shade a color. The caller sets the uniform `lights` to the
// strengths of ambient light, headlight and key light.
extern const char* const lighting_glsl;

} // namespace ciel::render
