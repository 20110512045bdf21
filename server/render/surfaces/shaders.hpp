// The programs that draw triangles, lines and points.
#pragma once

#include "render/context/gl.hpp"
#include "render/frame/frame.hpp"

namespace server::render {

// An attribute without an array has one value for all vertices, so one program draws primitives with and without
// arrays.
enum Attribute : GLuint {
    attribute_position = 0,
    attribute_normal = 1, // zero vector: flat shading by the triangle's plane
    attribute_scalar = 2,
    attribute_size = 3,  // diameter of a point, in picture pixels
    attribute_color = 4, // solid RGB, and the opacity
    // (row in ColorScales, or -1 for a solid color; 1 if lit, otherwise 0; number to subtract from the scalar)
    attribute_style = 5,
};

// Largest number of samples per pixel at which the edge of a point is computed. Points ignore further samples.
inline constexpr std::size_t most_point_samples = 8;

// A GL program, and the locations of its uniforms. A location is -1 if the program does not have the uniform.
struct Program {
    GLuint id = 0;
    GLint view = -1, projection = -1, scale = -1, parallel = -1, clip = -1; // in programs of triangles, lines, points
    GLint scale_colors = -1, scale_rules = -1;                              // in programs of triangles, lines, points
    GLint lights = -1;                                                      // in programs of triangles and points
    GLint look = -1, solid = -1, lit = -1;                                  // in the plain program of triangles
    GLint point_pixels = -1, line_reach = -1;                               // in programs of points
    GLint sample_count = -1, sample_places = -1; // in the program of points that are not peeled
    GLint farther = -1;                          // in the program of points between layers
    GLint viewport = -1;                         // in programs of lines and points
    GLint opaque_depth = -1, sheet_slopes = -1;  // in programs of lines and points (surface_slopes.hpp)
    GLint before_volume = -1, volume_limits = -1, cover_part = -1; // in programs of lines
    GLint half_width = -1, on_opaque = -1;                         // in programs of lines
    GLint nearer = -1, nearer_lines = -1;                          // in peeling programs of triangles, lines and points
    GLint own_lines = -1, behind = -1, number = -1, joining = -1;  // in the peeling program of lines
    GLint occlusion = -1, occlusion_stride = -1;                   // in the program of triangles with ambient occlusion
    GLint occlusion_strength = -1, occlusion_scale = -1;           // in the program of triangles with ambient occlusion
};

// The make functions throw Error with the compiler's or the linker's message.
[[nodiscard]] Program make_triangle_program(const Gl& gl);
// Draws the most common triangles: one color, normals per vertex, no clip plane.
[[nodiscard]] Program make_plain_program(const Gl& gl);
// These programs draw only fragments behind the previous layer. `recorded`: they also write the record of lines.
[[nodiscard]] Program make_peeling_program(const Gl& gl, bool recorded);
[[nodiscard]] Program make_peeling_line_program(const Gl& gl, bool recorded);
[[nodiscard]] Program make_peeling_point_program(const Gl& gl, bool recorded);
// Writes normals of triangles, in eye space and facing the viewer.
[[nodiscard]] Program make_normals_program(const Gl& gl);
// Writes R: slope of a triangle in window depth per pixel, G: slope limited by the triangle's extent in depth.
[[nodiscard]] Program make_slopes_program(const Gl& gl);
// Draws triangles that AmbientOcclusion darkens.
[[nodiscard]] Program make_occluded_program(const Gl& gl);
[[nodiscard]] Program make_line_program(const Gl& gl);
// Draws opaque points. Their edges are hard: a sample is covered or not.
[[nodiscard]] Program make_point_program(const Gl& gl);
// Draws transparent points between two layers. `on_surfaces`: the points may lie on surfaces.
[[nodiscard]] Program make_point_between_program(const Gl& gl, bool on_surfaces);

} // namespace server::render
