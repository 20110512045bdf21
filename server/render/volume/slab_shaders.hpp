// The programs that draw a volume's slabs.
#pragma once

#include "render/context/shader_program.hpp"

#include <compare>

namespace ciel::render {

enum VolumeAttribute : GLuint {
    volume_position = 0,
    volume_value = 1,
    volume_gradient = 2,
    volume_limits = 3,
};

// Slices: each for what a ray has in common with its slab; and boundary faces: for what no slice stands for.
struct SlabProgramKind {
    int parts = 1; // of a ray
    bool shaded = false, clipped = false, opaque = false, parallel = false;
    int table_rows = 1;
    double table_width = 1;                                   // in ranges
    auto operator<=>(const SlabProgramKind&) const = default; // NOLINT(modernize-use-nullptr): takes <=> for a 0
};
[[nodiscard]] ShaderProgram make_slice_program(const Gl& gl, const SlabProgramKind& kind);
// Polygons of a slice where a ray has nothing but the mesh in the slab: no boundary, no clip plane, no opaque surface,
// no eye. Parts of the ray and clip planes are nothing to it.
[[nodiscard]] ShaderProgram make_inner_program(const Gl& gl, const SlabProgramKind& kind);
[[nodiscard]] ShaderProgram make_edge_program(const Gl& gl, const SlabProgramKind& kind);

} // namespace ciel::render
