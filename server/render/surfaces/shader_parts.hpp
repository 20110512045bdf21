// Shader text shared by the programs of surfaces, lines and points.
#pragma once

#include "render/context/shader_program.hpp"
#include "render/surfaces/shaders.hpp"

namespace ciel::render {

// GLSL block `surface`, to follow "in" or "out": the output of surface_vertex for lines and triangles.
extern const char* const surface_block;
extern const std::string surface_vertex;
// depth_on_surface() of lines and points.
extern const char* const on_surface_glsl;
// is_seen() of peeled programs; recorded_glsl also has the record of a layer.
extern const char* const peeled_glsl;
extern const char* const recorded_glsl;

// Throws Error with the compiler's message.
[[nodiscard]] Program link(const Gl& gl, const std::vector<Stage>& stages);
// Returns a fragment shader: `defines`, then base_color(), the lighting, and `body`.
[[nodiscard]] std::string with_color_scale(const std::string& body, const std::string& defines = "");

} // namespace ciel::render
