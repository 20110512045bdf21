// Shader text that the server and the web page share: protocol/shading/.
#pragma once

namespace server::render {

// base_color() returns the color of a value, or a solid color. Needs the two textures that ColorScales binds.
extern const char* const color_scale_glsl;

// GLSL for fragment shaders: start_of_layer(), is_in_joint() and the constant `least`, for layers of depth peeling.
extern const char* const depth_layers_glsl;

// lit_surface() and lit_ball() shade a color. `lights`: strengths of ambient light, headlight and key light.
extern const char* const lighting_glsl;

} // namespace server::render
