// The programs that draw a volume.
#pragma once

#include "render/shader_program.hpp"

#include <compare>

namespace ciel::render {

enum VolumeAttribute : GLuint {
    volume_position = 0,
    volume_value = 1,
    volume_gradient = 2,
    volume_limits = 3,
};

// A ray is in the mesh in so many parts at most, from the eye on; slices after the last of them are drawn as if the
// mesh went on there.
inline constexpr int most_ray_parts = 8;

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
// Slices: each for what a ray has in common with its slab; and boundary faces: for what no slice stands for.
struct SlabProgramKind {
    int parts = 1; // of a ray
    bool shaded = false, clipped = false, opaque = false;
    int table_rows = 1;
    auto operator<=>(const SlabProgramKind&) const = default; // NOLINT(modernize-use-nullptr): takes <=> for a 0
};
[[nodiscard]] ShaderProgram make_slice_program(const Gl& gl, const SlabProgramKind& kind);
// Polygons of a slice where a ray has nothing but the mesh in the slab: no boundary, no clip plane, no opaque surface,
// no eye. Parts of the ray and clip planes are nothing to it.
[[nodiscard]] ShaderProgram make_inner_program(const Gl& gl, const SlabProgramKind& kind);
[[nodiscard]] ShaderProgram make_edge_program(const Gl& gl, const SlabProgramKind& kind);
// The finished volumes onto the picture; per sample as draw_per_sample() does it.
[[nodiscard]] ShaderProgram make_volume_picture_program(const Gl& gl, bool per_sample);

} // namespace ciel::render
