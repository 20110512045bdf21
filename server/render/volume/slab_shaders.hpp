// The programs that draw a volume's slabs.
#pragma once

#include "render/context/shader_program.hpp"

#include <compare>

namespace server::render {

enum VolumeAttribute : GLuint {
    volume_position = 0,
    volume_value = 1,
    volume_gradient = 2,
    volume_limits = 3,
};

// Slice programs draw the pieces of rays that contain a slice. Edge programs draw the other pieces, with the fragments
// of boundary faces.
struct SlabProgramKind {
    int parts = 1; // number of separate parts of a ray inside the mesh
    bool shaded = false, clipped = false, opaque = false, parallel = false;
    int table_rows = 1;
    // Extent of the transfer table, in widths of the color scale's range.
    double table_width = 1;
    auto operator<=>(const SlabProgramKind&) const = default; // NOLINT(modernize-use-nullptr): mistakes <=> for 0
};
[[nodiscard]] ShaderProgram make_slice_program(const Gl& gl, const SlabProgramKind& kind);
// Makes the program for inner triangles (inner_polygons.hpp). Near an inner triangle, the slab has no boundary face,
// clip plane or opaque surface, and the eye is not there either; the program tests for none of them. REQUIRES: `kind`
// has one part of the mesh along a ray, and no clipping.
[[nodiscard]] ShaderProgram make_inner_program(const Gl& gl, const SlabProgramKind& kind);
[[nodiscard]] ShaderProgram make_edge_program(const Gl& gl, const SlabProgramKind& kind);

} // namespace server::render
