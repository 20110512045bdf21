// The programs that find where rays are in a mesh, and that put finished volumes onto the picture.
#pragma once

#include "render/context/shader_program.hpp"

#include <string>

namespace ciel::render {

// A ray is in the mesh in so many parts at most, from the eye on; slices after the last of them are drawn as if the
// mesh went on there.
inline constexpr int most_ray_parts = 8;
// A program's text for rays of so many parts: `text` in place of LATER_PARTS, with a sampler part_1, part_2, ... each.
[[nodiscard]] std::string with_parts(std::string body, int parts, const std::string& text);

// Distances along a ray are depths: lengths along the view's axis.
//
// parts: where a ray enters (R) and leaves (G) the mesh; the first time, or next after the part in `before`.
[[nodiscard]] ShaderProgram make_part_program(const Gl& gl, bool first);
// Where a ray is between the frame's clip planes: from (R), to (G).
[[nodiscard]] ShaderProgram make_kept_program(const Gl& gl);
// First part, how far opaque surfaces let one see (B), and the window's depth where there is anything to see (A),
// for rays of so many parts.
[[nodiscard]] ShaderProgram make_limits_program(const Gl& gl, int parts);
// The same again, to be blended with others'.
[[nodiscard]] ShaderProgram make_limits_copy_program(const Gl& gl);
// The finished volumes onto the picture; for samples as draw_per_sample() does it.
enum class RaysOfPicture { one_for_each_pixel, one_for_samples, one_for_several_pixels };
[[nodiscard]] ShaderProgram make_volume_picture_program(const Gl& gl, RaysOfPicture rays);

} // namespace ciel::render
