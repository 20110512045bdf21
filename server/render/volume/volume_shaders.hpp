// The programs that find where rays are in a mesh, and that put finished volumes onto the picture.
#pragma once

#include "render/context/shader_program.hpp"

#include <string>

namespace ciel::render {

// The largest number of parts of a ray inside the mesh, counted from the eye. Slices behind the last part are drawn as
// if the mesh continued there.
inline constexpr int most_ray_parts = 8;
// Returns `body` with LATER_PARTS replaced by `text`, and samplers part_1, part_2, ... declared for rays of `parts`
// parts.
[[nodiscard]] std::string with_parts(std::string body, int parts, const std::string& text);

// Distances along a ray are depths: lengths along the view's axis.
//
// Writes where a ray enters (R) and leaves (G) the mesh. `first`: in the ray's first part; otherwise in the part behind
// the one in the texture `before`.
[[nodiscard]] ShaderProgram make_part_program(const Gl& gl, bool first);
// Writes where a ray enters (R) and leaves (G) the space between the frame's clip planes.
[[nodiscard]] ShaderProgram make_kept_program(const Gl& gl);
// Writes, for rays of `parts` parts, the first part (RG), the depth of the opaque surface (B), and the window depth
// where the visible volume begins (A).
[[nodiscard]] ShaderProgram make_limits_program(const Gl& gl, int parts);
// Copies the limits of one boundary. Blending takes the minimum over all boundaries.
[[nodiscard]] ShaderProgram make_limits_copy_program(const Gl& gl);
// Composites the finished volumes onto the picture. one_for_samples is for draw_per_sample().
enum class RaysOfPicture { one_for_each_pixel, one_for_samples, one_for_several_pixels };
[[nodiscard]] ShaderProgram make_volume_picture_program(const Gl& gl, RaysOfPicture rays);

} // namespace ciel::render
