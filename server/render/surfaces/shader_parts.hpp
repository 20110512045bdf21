// Shader text shared by the programs of surfaces, lines and points.
#pragma once

#include "render/context/shader_program.hpp"
#include "render/surfaces/shaders.hpp"

namespace server::render {

// GLSL interface block `surface`, to be written after "in" or "out". It is the output of surface_vertex.
extern const char* const surface_block;
extern const std::string surface_vertex;
// GLSL of depth_on_surface(), for lines and points.
extern const std::string on_surface_glsl;
// Both define is_seen(), which returns whether a fragment is behind the previous layer. recorded_glsl is for layers
// with transparent lines: it declares an output for the last transparent line at each pixel.
extern const char* const peeled_glsl;
extern const char* const recorded_glsl;

// Links a program and looks up its uniforms. Throws Error with the compiler's or the linker's message.
[[nodiscard]] Program link(const Gl& gl, const std::vector<Stage>& stages);
// Returns the text of a fragment shader: `defines`, then base_color(), the lighting, and `body`.
[[nodiscard]] std::string with_color_scale(const std::string& body, const std::string& defines = "");

} // namespace server::render
