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

// Variant of a slab program. The programs of slices draw the piece of a ray in a slab. The program of boundary faces
// draws the pieces that contain no slice.
struct SlabProgramKind {
    int parts = 1; // number of parts of a ray inside the mesh
    bool shaded = false, clipped = false, opaque = false, parallel = false;
    int table_rows = 1;
    double table_width = 1;                                   // extent of the table, in ranges of the color scale
    auto operator<=>(const SlabProgramKind&) const = default; // NOLINT(modernize-use-nullptr): takes <=> for a 0
};
[[nodiscard]] ShaderProgram make_slice_program(const Gl& gl, const SlabProgramKind& kind);
// For inner polygons (inner_polygons.hpp): around them, the slab has no boundary face, clip plane, opaque surface or
// eye. `kind` must have one part and no clipping.
[[nodiscard]] ShaderProgram make_inner_program(const Gl& gl, const SlabProgramKind& kind);
// Draws the pieces without a slice, by boundary faces.
[[nodiscard]] ShaderProgram make_edge_program(const Gl& gl, const SlabProgramKind& kind);

} // namespace ciel::render
