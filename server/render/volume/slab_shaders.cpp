// Shaders that draw the slabs of a volume. The middle plane of each slab cuts the mesh; the cut is the slice of the
// slab. The part of a ray inside the mesh is divided into pieces at the borders of the slabs. Exactly one fragment
// draws each piece, so that each fragment knows the property and its gradient at one point of its piece:
//   A fragment of a slice draws the piece that contains the slice.
//   A fragment of a front face draws the piece that begins on the face, unless the piece contains a slice.
//   A fragment of a back face draws the piece that ends on the face, if this piece begins at the slab's front and
//   contains no slice.
// Near an entry or exit, rounding decides which pixels a slice covers, so the fragment of the face draws the piece.
// If a ray ends on an opaque surface before the slice of a slab, the fragment in the slab in front extends its piece to
// the surface. If the eye is inside the mesh, the fragment in the slab of the first slice extends its piece to the eye.
// Vertex shaders pass the constants of a slab to the fragments. If these were uniforms, llvmpipe would look up their
// values for each pixel, which takes a third of the time of these programs.
#include "render/volume/slab_shaders.hpp"

#include "render/volume/volume_shaders.hpp"

#include <string>

namespace server::render {
namespace {

// Outputs values as positions in the transfer table, from 0 to 1, and gradients in eye space as change of this position
// per scaled length. Lengths are scaled, because squares of very large lengths (a galaxy in meters) overflow a float.
constexpr const char* slab_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in float value;
layout(location = 2) in vec3 gradient;
layout(location = 3) in vec2 limits;
uniform mat4 transform;
uniform mat4 view;
uniform vec2 to_share;
uniform float density; // 1 / unit length
uniform float scale;
out vec4 property;
flat out vec4 cell;
#ifdef INNER
// Half of the slab along a ray: xyz + w * position in eye space.
uniform vec4 half_of;
out vec3 half_piece;
#else
uniform vec4 rays;
uniform vec3 across;
uniform vec3 start;
uniform vec2 pixel_size;
flat out vec4 ray_row;
flat out vec4 across_row;
flat out vec4 start_row;
#ifdef EDGE
uniform float half_slab;
uniform float slice_place;
uniform float slab;
uniform float last_slab;
flat out vec4 slab_row;
#endif
#endif
invariant gl_Position;
void main() {
    gl_Position = transform * vec4(position, 1.0);
    property = vec4(mat3(view) * gradient * (to_share.x / scale), value * to_share.x + to_share.y);
    vec2 ends = limits * to_share.x + to_share.y;
    cell = vec4(clamp(vec2(min(ends.x, ends.y), max(ends.x, ends.y)), 0.0, 1.0), density / scale, scale);
#ifdef INNER
    half_piece = scale * (half_of.xyz + half_of.w * vec3(view * vec4(position, 1.0)));
#else
    ray_row = rays;
#ifdef EDGE
    across_row = vec4(across, half_slab);
    start_row = vec4(start, slice_place);
    slab_row = vec4(slab, last_slab, pixel_size);
#else
    across_row = vec4(across, pixel_size.x);
    start_row = vec4(start, pixel_size.y);
#endif
#endif
}
)";

constexpr const char* ray = R"(
// Change of a ray's eye-space xy per unit of depth. xy: at the picture's corner, zw: change per pixel.
flat in vec4 ray_row;
// Advance of a ray across the slabs per unit of depth. x: at the picture's corner, yz: change per pixel.
flat in vec4 across_row;
// Position of a ray across the slabs at depth 0. x: at the picture's corner, yz: change per pixel (parallel rays).
flat in vec4 start_row;
const float never = 1e30;

vec3 ray_along() { return vec3(ray_row.xy + ray_row.zw * gl_FragCoord.xy, -1.0); } // in eye space, per unit of depth
float ray_across() { return across_row.x + dot(across_row.yz, gl_FragCoord.xy); }
float ray_start() { return start_row.x + dot(start_row.yz, gl_FragCoord.xy); }

// Returns depths of a ray: entry and exit of its first part inside the mesh, and the opaque surface.
#ifdef OPAQUE
uniform sampler2D limits;
vec3 limits_of(vec2 place) { return texture(limits, place).xyz; }
#else
uniform sampler2D first_part;
vec3 limits_of(vec2 place) {
    vec2 part = texture(first_part, place).xy;
    return vec3(part.x > part.y ? -never : part.x, part.y, never); // entry behind the exit: the eye is inside the mesh
}
#endif
)";

constexpr const char* light = R"(
uniform sampler2D table;
in vec4 property;   // xyz: gradient per scaled length, w: position in the table
// x, y: smallest and largest position in the table within the mesh's cell. z: density per scaled length. w: `scale`.
flat in vec4 cell;
out vec4 picture;

// Returns the light and opacity of a piece of a ray, premultiplied. `way`: vector along the ray.
// `rise`: change of the property along `way`. `first`, `last`: property at the piece's ends.
// `length`: scaled length of the piece.
vec4 light(vec3 way, float rise, float first, float last, float length) {
    float a = clamp(first, cell.x, cell.y);
    float b = clamp(last, cell.x, cell.y);
    vec4 mean = texture(table, vec2(0.5 * (a + b), (abs(b - a) * (ROWS - 1.0) + 0.5) / ROWS));
    float loss = mean.a * length * cell.z;
    // Small losses use a series, because 1 - exp(-loss) has too few digits if many thin slabs are added.
    float opacity = loss < 0.25 ? loss * (1.0 - loss * (0.5 - loss * (1.0 / 6.0 - loss * (1.0 / 24.0))))
                                : 1.0 - exp(-loss);
    vec3 color = mean.rgb;
#ifdef CLIPPED
    // At a clip plane, dense pieces are cut open, and only the front of such a piece is visible. Therefore the
    // color is the mean over the front of the piece. `share` is the length of this front, as a share of the piece. The
    // middle of the front is the mean depth from which the visible light comes.
    float share = loss < 0.01 ? 1.0 - loss / 6.0 : 2.0 / loss - 2.0 / (exp(min(loss, 80.0)) - 1.0);
    float end = mix(a, b, share);
    color = texture(table, vec2(0.5 * (a + end), (abs(end - a) * (ROWS - 1.0) + 0.5) / ROWS)).rgb;
#endif
#ifdef SHADED
    float steep = dot(property.xyz, property.xyz);
    float facing = min(rise * rise / max(steep * dot(way, way), 1e-30), 1.0);
    // Where the property changes by less than a third of its range along the whole mesh, there is no surface to light.
    float part = steep / (steep + 0.1 / (TABLE_WIDTH * TABLE_WIDTH));
    float shine = facing * facing;
    shine *= shine;
    shine *= shine;
    color = color * (1.0 - part * 0.6 * (1.0 - sqrt(facing))) + 0.12 * part * shine;
#endif
    return vec4(color * opacity, opacity);
}
)";

constexpr const char* inner_fragment = R"(
in vec3 half_piece; // along the ray from the slice to the back of the slab
void main() {
    float rise = dot(property.xyz, half_piece);
    picture = light(half_piece, rise, property.w - rise, property.w + rise, 2.0 * sqrt(dot(half_piece, half_piece)));
}
)";

constexpr const char* clipping = R"(
#ifdef CLIPPED
uniform sampler2D between_planes;
vec2 span_at(vec2 place) { return texture(between_planes, place).xy; }
#endif
)";

// Depths are converted to positions along the ray, in half slabs from the slice. The slab of the slice is from -1 to 1.
constexpr const char* slice_fragment = R"(
void main() {
    float per_depth = ray_across();
    float from_eye = ray_start();
    vec2 pixel = gl_FragCoord.xy * vec2(across_row.w, start_row.w);
    vec3 first = limits_of(pixel) * per_depth - from_eye;
    vec2 part = first.xy;
    LATER_PARTS
    bool yields = part.x > -0.3 || part.y < 0.3 || first.z < 0.0 || from_eye <= 0.0 || per_depth <= 0.0;
    float front = part.x < -from_eye && from_eye < 2.0 ? -from_eye : max(-1.0, -from_eye);
    float from = max(front, part.x);
    float to = min(part.y, first.z < 2.0 ? first.z : 1.0);
#ifdef CLIPPED
    vec2 span = span_at(pixel) * per_depth - from_eye;
    from = max(from, span.x);
    to = min(to, span.y);
#endif
    vec3 half_piece = ray_along() * (cell.w / per_depth);
    float rise = dot(property.xyz, half_piece);
    vec4 seen = light(half_piece, rise, property.w + rise * from, property.w + rise * to,
                      max(to - from, 0.0) * sqrt(dot(half_piece, half_piece)));
    picture = yields ? vec4(0.0) : seen;
}
)";

// Uses depths instead of positions across the slab, because these are constant on a ray that runs along the slab.
constexpr const char* edge_fragment = R"(
flat in vec4 slab_row; // index of the slab, index of the last slab, 1 / picture size
#ifdef PARALLEL
uniform vec2 parallel_depths; // nearest depth, and difference from it to the farthest
#endif
bool is_in_slab(float place) {
    return clamp(floor(place / (2.0 * across_row.w)), 0.0, slab_row.y) == slab_row.x;
}
bool yields(float slice, vec2 part, float half_depth) {
    float margin = 0.3 * half_depth;
    return slice - part.x < margin || part.y - slice < margin || slice <= 0.0;
}
// Returns the depth where the slab begins; 0 (the eye) if the eye is inside the mesh and within a slab of the slice.
float front(float slice, vec2 part, float half_depth) {
    return part.x < 0.0 && slice < 2.0 * half_depth ? 0.0 : max(slice - half_depth, 0.0);
}
// Returns the depth of the next exit, of an opaque surface before the next slice, or of the slab's back.
float back(float slice, vec2 part, float half_depth, float sight) {
    return min(part.y, sight < slice + 2.0 * half_depth ? sight : slice + half_depth);
}
void main() {
#ifdef PARALLEL
    float t = parallel_depths.x + gl_FragCoord.z * parallel_depths.y;
#else
    float t = 1.0 / gl_FragCoord.w;
#endif
    vec3 along = ray_along();
    float across = ray_across(), start = ray_start();
    if (!is_in_slab(start + across * t)) discard;
    if (abs(across) < 1e-9) across = 1e-9;
    float slice = (start_row.w - start) / across;
    float half_depth = across_row.w / abs(across);
    vec2 pixel = gl_FragCoord.xy * slab_row.zw;
    vec3 first = limits_of(pixel);
    vec2 part = first.xy;
    LATER_PARTS
    float from = t, to = t;
    if (gl_FrontFacing) {
        part.x = t;
        if (t < first.z && (first.z < slice || yields(slice, part, half_depth)))
            to = back(slice, part, half_depth, first.z);
    } else {
        part.y = t;
        float begin = front(slice, part, half_depth);
        // Whether the ray enters the mesh in this slab. The fragment of the front face there then draws the piece.
        bool begins_here = part.x >= 0.0 && is_in_slab(start + across * part.x);
        if (first.z >= slice && !begins_here && yields(slice, part, half_depth)) from = begin;
        to = min(t, first.z);
    }
#ifdef CLIPPED
    vec2 span = span_at(pixel);
    from = max(from, span.x);
    to = min(to, span.y);
#endif
    float rise = dot(property.xyz, along);
    vec2 ends = (vec2(from, to) - t) * cell.w;
    picture = light(along, rise, property.w + rise * ends.x, property.w + rise * ends.y,
                    max(ends.y - ends.x, 0.0) * sqrt(dot(along, along)));
}
)";

// Returns GLSL that selects the part of the ray with the slice or, for `edge`, with an end on the boundary face.
std::string later_parts(int parts, bool edge) {
    std::string text;
    for (int i = 1; i < parts; ++i) {
        const std::string next = "texture(part_" + std::to_string(i) + ", pixel).xy";
        text += edge
                    ? "{ vec2 next = " + next +
                          ";\nif (gl_FrontFacing ? abs(next.x - t) < abs(part.x - t) : abs(next.y - t) < "
                          "abs(part.y - t)) part = next; }\n"
                    : "{ vec2 next = " + next + " * per_depth - from_eye;\nif (part.y + next.x < 0.0) part = next; }\n";
    }
    if (parts == most_ray_parts && !edge) text += "if (part.y < -1.0) part = vec2(-never, never);\n";
    return text;
}

std::string defines_of(const SlabProgramKind& kind) {
    return std::string("#version 330 core\n") + (kind.shaded ? "#define SHADED\n" : "") +
           (kind.clipped ? "#define CLIPPED\n" : "") + (kind.opaque ? "#define OPAQUE\n" : "") +
           (kind.parallel ? "#define PARALLEL\n" : "") + "#define ROWS " + std::to_string(kind.table_rows) + ".0\n" +
           "#define TABLE_WIDTH " + std::to_string(kind.table_width) + "\n";
}

ShaderProgram make_slab_program(const Gl& gl, bool edge, const SlabProgramKind& kind) {
    const std::string defines = defines_of(kind) + (edge ? "#define EDGE\n" : "");
    return make_shader_program(
        gl, defines + slab_vertex,
        defines + ray + light + clipping +
            with_parts(edge ? edge_fragment : slice_fragment, kind.parts, later_parts(kind.parts, edge)));
}

} // namespace

ShaderProgram make_slice_program(const Gl& gl, const SlabProgramKind& kind) {
    return make_slab_program(gl, false, kind);
}

ShaderProgram make_inner_program(const Gl& gl, const SlabProgramKind& kind) {
    const std::string defines = defines_of(kind) + "#define INNER\n";
    return make_shader_program(gl, defines + slab_vertex, defines + light + inner_fragment);
}

ShaderProgram make_edge_program(const Gl& gl, const SlabProgramKind& kind) { return make_slab_program(gl, true, kind); }

} // namespace server::render
