// Shader text shared by the programs of surfaces, lines and points.
#pragma once

#include "render/context/shader_program.hpp"
#include "render/surfaces/shaders.hpp"

namespace server::render {

// GLSL interface block `surface`, to be written after "in" or "out". It is the output of surface_vertex.
extern const char* const surface_block;
extern const std::string surface_vertex;
// GLSL: protocol/shading/depth_layers.glsl, then depth_on_surface(), for lines and points.
extern const std::string on_surface_glsl;
// Returns the macros of depth_layers.glsl for a program that draws layers. `recorded`: the layers record lines.
[[nodiscard]] std::string layer_macros(bool recorded);

// Links a program and looks up its uniforms. Throws Error with the compiler's or the linker's message.
[[nodiscard]] Program link(const Gl& gl, const std::vector<Stage>& stages);
// Returns the text of a fragment shader: `defines`, then base_color(), the lighting, and `body`.
[[nodiscard]] std::string with_color_scale(const std::string& body, const std::string& defines = "");

} // namespace server::render
