// The programs of surfaces: triangles, lines, points.
#pragma once

#include "render/context/gl.hpp"
#include "render/frame/frame.hpp"

namespace ciel::render {

// Vertex attributes. In OpenGL an attribute without an array has one value for the whole mesh. So one program draws
// every kind of mesh.
enum Attribute : GLuint {
    attribute_position = 0,
    attribute_normal = 1, // zero: shaded by the triangle's own plane
    attribute_scalar = 2,
    attribute_size = 3,  // of a point, in pixels
    attribute_color = 4, // RGB of a solid mesh, and the opacity
    attribute_style = 5, // (row of the frame's ColorScales, or -1 for solid; 1 when lit; ScaleRow::origin)
};

inline constexpr std::size_t most_point_samples = 8; // per pixel; points ignore further samples

struct Program {
    GLuint id = 0;
    GLint view = -1, projection = -1, scale = -1, parallel = -1, clip = -1; // triangles, lines and points
    GLint scale_colors = -1, scale_rules = -1;                              // likewise
    GLint lights = -1;                                                      // triangles and points
    GLint look = -1, solid = -1, lit = -1;                                  // plain triangles
    GLint point_pixels = -1, line_reach = -1;                               // points
    GLint sample_count = -1, sample_places = -1;                            // points that are not peeled
    GLint farther = -1;                                                     // points between layers
    GLint viewport = -1;                                                    // lines and points
    GLint opaque_depth = -1, sheet_slopes = -1;                             // likewise (surface_slopes.hpp)
    GLint before_volume = -1, volume_limits = -1, cover_part = -1;          // lines
    GLint half_width = -1, on_opaque = -1;                                  // likewise
    GLint nearer = -1, nearer_lines = -1;                         // triangles, lines and points that are peeled
    GLint own_lines = -1, behind = -1, number = -1, joining = -1; // lines that are peeled
    GLint occlusion = -1, occlusion_stride = -1;                  // triangles with ambient occlusion
    GLint occlusion_strength = -1, occlusion_scale = -1;          // likewise
};

// Each throws Error with the compiler's message.
[[nodiscard]] Program make_triangle_program(const Gl& gl);
// The same for the most common mesh: one color, normals of its own, no clip plane.
[[nodiscard]] Program make_plain_program(const Gl& gl);
// Triangles, lines and points of a layer: only fragments behind a depth (depth_peeling.hpp). `recorded`: with a second
// output, the record of lines and points (recorded_glsl in shader_parts.cpp).
[[nodiscard]] Program make_peeling_program(const Gl& gl, bool recorded);
[[nodiscard]] Program make_peeling_line_program(const Gl& gl, bool recorded);
[[nodiscard]] Program make_peeling_point_program(const Gl& gl, bool recorded);
// Writes normals of triangles, towards the viewer, in eye space.
[[nodiscard]] Program make_normals_program(const Gl& gl);
// Writes slopes of triangles in window depth per pixel: the slope, and the slope limited by the triangle's extent.
[[nodiscard]] Program make_slopes_program(const Gl& gl);
// Triangles darkened by AmbientOcclusion.
[[nodiscard]] Program make_occluded_program(const Gl& gl);
[[nodiscard]] Program make_line_program(const Gl& gl);
// Points of full opacity, cut per sample.
[[nodiscard]] Program make_point_program(const Gl& gl);
// Points of less than full opacity, between two layers; `on_surfaces`: they may lie on surfaces.
[[nodiscard]] Program make_point_between_program(const Gl& gl, bool on_surfaces);

} // namespace ciel::render
