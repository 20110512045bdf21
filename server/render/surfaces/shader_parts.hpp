// What the programs of surfaces, lines and points have in common; for those who make them.
#pragma once

#include "render/context/shader_program.hpp"
#include "render/surfaces/shaders.hpp"

namespace ciel::render {

// What the vertices tell lines, triangles and points: `surface`, after "in" or "out".
extern const char* const surface_block;
extern const std::string surface_vertex;
// depth_on_surface() of lines and points.
extern const char* const on_surface_glsl;
// is_seen() of what is peeled; the second with the record of a layer.
extern const char* const peeled_glsl;
extern const char* const recorded_glsl;

[[nodiscard]] Program link(const Gl& gl, const std::vector<Stage>& stages);
// `defines` come first.
[[nodiscard]] std::string with_color_scale(const std::string& body, const std::string& defines = "");

} // namespace ciel::render
