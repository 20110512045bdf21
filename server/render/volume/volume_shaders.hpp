// The programs that find where rays are in a mesh, and that put finished volumes onto the picture.
#pragma once

#include "render/context/shader_program.hpp"

#include <string>

namespace ciel::render {

// The largest number of parts of a ray inside the mesh, counted from the eye. Slices behind the last part are drawn as
// if the mesh continued there.
inline constexpr int most_ray_parts = 8;
// Returns the text for rays of `parts` parts: `text` replaces LATER_PARTS; declares samplers part_1, part_2, ...
[[nodiscard]] std::string with_parts(std::string body, int parts, const std::string& text);

// Distances along a ray are depths: lengths along the view's axis.
//
// Writes where a ray enters (R) and leaves (G) the mesh: its first part, or the next one after the part in `before`.
[[nodiscard]] ShaderProgram make_part_program(const Gl& gl, bool first);
// Writes where a ray enters (R) and leaves (G) the space between the frame's clip planes.
[[nodiscard]] ShaderProgram make_kept_program(const Gl& gl);
// Writes, for rays of `parts` parts, the first part (RG), the depth of the opaque surface (B), and the window depth
// where the visible volume begins (A).
[[nodiscard]] ShaderProgram make_limits_program(const Gl& gl, int parts);
// Copies limits, to be blended with those of other boundaries.
[[nodiscard]] ShaderProgram make_limits_copy_program(const Gl& gl);
// Composites the finished volumes onto the picture. one_for_samples is for draw_per_sample().
enum class RaysOfPicture { one_for_each_pixel, one_for_samples, one_for_several_pixels };
[[nodiscard]] ShaderProgram make_volume_picture_program(const Gl& gl, RaysOfPicture rays);

} // namespace ciel::render
