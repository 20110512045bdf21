// Programs that find where rays are inside a mesh, and that composite the finished volumes.
#pragma once

#include "render/context/shader_program.hpp"

#include <string>

namespace server::render {

// Largest number of parts of a ray inside the mesh. Behind them, slices are drawn as if the mesh continued.
inline constexpr int most_ray_parts = 8;
// Returns the shader text `body` with `text` instead of LATER_PARTS, after the samplers part_1 ... part_{parts - 1}.
[[nodiscard]] std::string with_parts(std::string body, int parts, const std::string& text);

// Positions along a ray are depths: distances from the eye along the view direction.
// The program writes where a ray enters (R) and leaves (G) the mesh. `first`: true for the first part of a ray, false
// for the part behind the part in the texture `before`.
[[nodiscard]] ShaderProgram make_part_program(const Gl& gl, bool first);
// The program writes the depths at which a ray enters (R) and leaves (G) the space between the frame's clip planes.
[[nodiscard]] ShaderProgram make_kept_program(const Gl& gl);
// For rays with `parts` parts, the program writes the first part (RG), the depth of the opaque surface (B), and the
// window depth at which the visible volume begins (A).
[[nodiscard]] ShaderProgram make_limits_program(const Gl& gl, int parts);
// The program copies the limits of one boundary. Blending takes the minimum over all boundaries.
[[nodiscard]] ShaderProgram make_limits_copy_program(const Gl& gl);
// The program composites the finished volumes onto the picture. one_for_samples is for draw_per_sample().
enum class RaysOfPicture { one_for_each_pixel, one_for_samples, one_for_several_pixels };
[[nodiscard]] ShaderProgram make_volume_picture_program(const Gl& gl, RaysOfPicture rays);

} // namespace server::render
