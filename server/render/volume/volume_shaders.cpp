// Which piece of a ray is drawn by whom. The middle planes of the slabs cut the mesh into slices; a ray meets them, and
// enters and leaves the mesh through boundary faces, at any place between. Of what a ray has inside the mesh,
//   a slice has the piece within its slab that contains it: from the slab's front or the last entry to the slab's back
//     or the next exit;
//   a front face has the piece within its slab that begins on it, unless there is a slice in that;
//   a back face has the piece within its slab that ends on it, if that begins with the slab, unless there is a slice.
// So every piece belongs to one fragment, which knows the property and its gradient at some place of it. Where an entry
// or exit is all but on the slice, rounding decides which pixels the slice covers: there it leaves its piece to the
// face. An opaque surface has no property: a piece that ends on it before the slice belongs to the fragment of the slab
// in front. So does the piece from an eye inside the mesh to the first slice belong to the fragment of the slab behind.
// Clip planes cut slices and faces nowhere: each fragment draws of its piece what lies between the planes, where a ray
// is in one stretch, for what they keep is convex.
#include "render/volume/volume_shaders.hpp"

#include "render/per_sample.hpp"

#include <string>

namespace ciel::render {
namespace {

constexpr const char* version = "#version 330 core\n";

constexpr const char* part_vertex = R"(
layout(location = 0) in vec3 position;
uniform mat4 transform;
invariant gl_Position;
void main() { gl_Position = transform * vec4(position, 1.0); }
)";

// Depth of a fragment.
constexpr const char* depth = R"(
uniform vec2 parallel_depths; // nearest, and from there to the farthest; none for a perspective
float fragment_depth() {
    return parallel_depths.y > 0.0 ? parallel_depths.x + gl_FragCoord.z * parallel_depths.y : 1.0 / gl_FragCoord.w;
}
)";

// An inner wall is an exit and an entry at once, of two triangles whose corners are rounded to shares of a pixel: the
// steeper it is seen, the farther apart their depths are. Of a ray's first part, an entry behind the exit says that the
// eye is inside; so there it is put as far behind as rounding may have brought it before.
constexpr const char* part_fragment = R"(
out vec4 part;
#ifdef NEXT
uniform sampler2D before;
#else
uniform float eye_in_bounds; // 1 or 0
#endif
const float never = 1e30;
void main() {
    float t = fragment_depth();
    float rounding = 1e-5 * t;
    float apart = rounding + 0.05 * fwidth(t);
#ifdef NEXT
    vec2 last = texelFetch(before, ivec2(gl_FragCoord.xy), 0).xy;
    if (last.x > last.y) last.x = -never; // the eye was inside
    if (gl_FrontFacing ? t <= max(last.y - apart, last.x + rounding) : t <= last.y + rounding) discard;
    float entry = t;
#else
    float entry = t + eye_in_bounds * apart;
#endif
    part = gl_FrontFacing ? vec4(entry, never, 0.0, 0.0) : vec4(never, t, 0.0, 0.0);
}
)";

constexpr const char* ray_uniforms = R"(
uniform vec2 ray_corner; // sideways per depth at the picture's corner
uniform vec2 ray_step;   // and per pixel
uniform vec2 side_corner; // where a parallel ray starts
uniform vec2 side_step;
)";

constexpr const char* kept_fragment = R"(
uniform vec4 planes[6]; // along the eye's axes; (0, 0, 0, 1) keeps everything
out vec4 kept;
const float never = 1e30;
void main() {
    vec3 along = vec3(ray_corner + ray_step * gl_FragCoord.xy, -1.0);
    vec4 start = vec4(side_corner + side_step * gl_FragCoord.xy, 0.0, 1.0);
    vec2 span = vec2(0.0, never);
    for (int i = 0; i < 6; ++i) {
        float inside = dot(planes[i], start);
        float rate = dot(planes[i].xyz, along);
        if (rate > 0.0) span.x = max(span.x, -inside / rate);
        if (rate < 0.0) span.y = min(span.y, -inside / rate);
        if (rate == 0.0 && inside < 0.0) span.y = -never;
    }
    kept = vec4(span, 0.0, 0.0);
}
)";

constexpr const char* limits_fragment = R"(
uniform sampler2D first_part;
uniform sampler2D between_planes;
uniform float has_planes;
uniform sampler2D opaque;
uniform float has_opaque;
uniform vec2 viewport;
uniform vec2 depth_row; // of the projection: from -depth and 1
uniform float parallel;
out vec4 limits;
const float never = 1e30;
// What of a part the planes keep; nothing where it begins behind its end.
vec2 kept_of(vec2 part, vec2 kept) { return vec2(max(part.x, kept.x), min(part.y, kept.y)); }
float window_depth(vec2 first) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 kept = has_planes > 0.5 ? texelFetch(between_planes, pixel, 0).xy : vec2(0.0, never);
    vec2 seen = kept_of(first, kept);
    LATER_PARTS
    if (seen.x >= seen.y) return 1.0;
    return 0.5 + 0.5 * (depth_row.y - depth_row.x * seen.x) / (parallel > 0.5 ? 1.0 : max(seen.x, 1e-30));
}
void main() {
    vec2 part = texelFetch(first_part, ivec2(gl_FragCoord.xy), 0).xy;
    if (part.x > part.y) part.x = -never; // the eye is inside
    float window = window_depth(part);
    float sight = never;
    if (has_opaque > 0.5) {
        float z = texelFetch(opaque, ivec2(gl_FragCoord.xy * (vec2(textureSize(opaque, 0)) / viewport)), 0).r;
        float ndc = 2.0 * z - 1.0;
        if (z < 1.0) sight = parallel > 0.5 ? (depth_row.y - ndc) / depth_row.x : depth_row.y / (ndc + depth_row.x);
    }
    limits = vec4(part, sight, window);
}
)";

constexpr const char* limits_copy_fragment = R"(
uniform sampler2D limits;
out vec4 copy;
void main() { copy = texelFetch(limits, ivec2(gl_FragCoord.xy), 0); }
)";

// Values come as shares of the range, gradients along the eye's axes.
constexpr const char* slab_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in float value;
layout(location = 2) in vec3 gradient;
layout(location = 3) in vec2 limits;
uniform mat4 transform;
uniform mat4 view;
uniform vec2 to_share;
out float middle;
out vec3 slope;
flat out vec2 bounds;
#ifdef INNER
uniform vec4 half_of; // half a slab along a ray: so much, and so much of the way from the eye
out vec3 half_piece;
#endif
invariant gl_Position;
void main() {
    gl_Position = transform * vec4(position, 1.0);
    middle = value * to_share.x + to_share.y;
    slope = mat3(view) * gradient * to_share.x;
    vec2 ends = limits * to_share.x + to_share.y;
    bounds = clamp(vec2(min(ends.x, ends.y), max(ends.x, ends.y)), 0.0, 1.0);
#ifdef INNER
    half_piece = half_of.xyz + half_of.w * vec3(view * vec4(position, 1.0));
#endif
}
)";

constexpr const char* ray = R"(
uniform float across_corner; // how far a ray gets across the slabs per depth: at the picture's corner
uniform vec2 across_step;    // and per pixel
uniform float start_corner;  // where across the slabs it is at depth 0
uniform vec2 start_step;
uniform float slice_place;
uniform float half_slab;
const float never = 1e30;

struct Ray {
    vec3 along;       // per depth
    float across;     // how far across the slabs it gets per depth
    float start;      // its place across the slabs at depth 0
    float slice;      // depth of the slice
    float half_depth; // of the slab
};
Ray ray_here() { // of each fragment: sums of products that do not depend on the pixel are uniforms
    Ray ray;
    vec2 at = gl_FragCoord.xy;
    ray.along = vec3(ray_corner + ray_step * at, -1.0);
    ray.across = across_corner + dot(across_step, at);
    if (abs(ray.across) < 1e-9) ray.across = 1e-9;
    ray.start = start_corner + dot(start_step, at);
    float depth_per_place = 1.0 / ray.across;
    ray.slice = (slice_place - ray.start) * depth_per_place;
    ray.half_depth = half_slab * abs(depth_per_place);
    return ray;
}

// Its first part, and how far opaque surfaces let one see.
#ifdef OPAQUE
uniform sampler2D limits;
vec3 limits_of(ivec2 pixel) { return texelFetch(limits, pixel, 0).xyz; }
#else
uniform sampler2D first_part;
vec3 limits_of(ivec2 pixel) {
    vec2 part = texelFetch(first_part, pixel, 0).xy;
    return vec3(part.x > part.y ? -never : part.x, part.y, never); // the eye is inside
}
#endif
)";

constexpr const char* light = R"(
uniform sampler2D table;
uniform float density; // 1 / unit length
uniform float steepness;
in float middle;
in vec3 slope;
flat in vec2 bounds;
out vec4 picture;

// Of a piece of a ray: by how much the property rises along `way`, of which `length` is so many that the piece is
// `length` long; the property at its ends.
vec4 light(vec3 way, float rise, float first, float last, float length) {
    float a = clamp(first, bounds.x, bounds.y);
    float b = clamp(last, bounds.x, bounds.y);
    vec4 mean = texture(table, vec2(0.5 * (a + b), (abs(b - a) * (ROWS - 1.0) + 0.5) / ROWS));
    float loss = mean.a * length * density;
    // exp alone has too few digits where thin slabs add up.
    float opacity = loss < 0.25 ? loss * (1.0 - loss * (0.5 - loss * (1.0 / 6.0 - loss * (1.0 / 24.0))))
                                : 1.0 - exp(-loss);
    vec3 color = mean.rgb;
#ifdef CLIPPED
    // Pieces of any length end on a plane. What is far behind it in a dense one is not seen: one so much shorter, from
    // which all is seen alike, has its middle where the light that comes out has its own.
    float share = loss < 0.01 ? 1.0 - loss / 6.0 : 2.0 / loss - 2.0 / (exp(min(loss, 80.0)) - 1.0);
    float end = mix(a, b, share);
    color = texture(table, vec2(0.5 * (a + end), (abs(end - a) * (ROWS - 1.0) + 0.5) / ROWS)).rgb;
#endif
#ifdef SHADED
    float steep = dot(slope, slope);
    float facing = min(rise * rise / max(steep * dot(way, way), 1e-30), 1.0);
    float part = steep / (steep + steepness);
    float shine = facing * facing;
    shine *= shine;
    shine *= shine;
    color = color * (1.0 - part * 0.6 * (1.0 - sqrt(facing))) + 0.12 * part * shine;
#endif
    return vec4(color * opacity, opacity);
}
)";

// Of the piece between two depths, the property known at `t` between or near them.
constexpr const char* light_between = R"(
vec4 light_between(vec3 along, float t, float from, float to) {
    float rise = dot(slope, along);
    return light(along, rise, middle + rise * (from - t), middle + rise * (to - t),
                 max(to - from, 0.0) * sqrt(dot(along, along)));
}
)";

constexpr const char* inner_fragment = R"(
in vec3 half_piece; // from the slice to the back of the slab
void main() {
    float rise = dot(slope, half_piece);
    picture = light(half_piece, rise, middle - rise, middle + rise, 2.0 * sqrt(dot(half_piece, half_piece)));
}
)";

constexpr const char* ownership = R"(
bool yields(float slice, vec2 part, float half_depth) {
    float margin = 0.3 * half_depth;
    return slice - part.x < margin || part.y - slice < margin || slice <= 0.0;
}
// The front of the slab, or the eye.
float front(float slice, vec2 part, float half_depth) {
    return part.x < 0.0 && slice < 2.0 * half_depth ? 0.0 : max(slice - half_depth, 0.0);
}
// The back of the slab, or what ends the ray before the next slice.
float back(float slice, vec2 part, float half_depth, float sight) {
    return min(part.y, sight < slice + 2.0 * half_depth ? sight : slice + half_depth);
}
)";

constexpr const char* clipping = R"(
#ifdef CLIPPED
uniform sampler2D between_planes;
vec2 kept(vec2 piece, ivec2 pixel) {
    vec2 span = texelFetch(between_planes, pixel, 0).xy;
    return vec2(max(piece.x, span.x), min(piece.y, span.y));
}
#else
vec2 kept(vec2 piece, ivec2 pixel) { return piece; }
#endif
)";

constexpr const char* slice_fragment = R"(
void main() {
    Ray ray = ray_here();
    // From the plane: the depths of thin triangles are as coarse as the rasteriser's corners.
    float t = ray.slice;
    float half_depth = ray.half_depth;
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 first = limits_of(pixel);
    vec2 part = first.xy;
    LATER_PARTS
    vec2 piece = kept(vec2(max(front(t, part, half_depth), part.x), back(t, part, half_depth, first.z)), pixel);
    picture = t > first.z || yields(t, part, half_depth) ? vec4(0.0) : light_between(ray.along, t, piece.x, piece.y);
}
)";

constexpr const char* edge_fragment = R"(
uniform float first_place;
uniform float slab;
uniform float last_slab;
bool is_in_slab(Ray ray, float t) {
    return clamp(floor((ray.start + ray.across * t - first_place) / (2.0 * half_slab)), 0.0, last_slab) == slab;
}
void main() {
    Ray ray = ray_here();
    float t = fragment_depth();
    if (!is_in_slab(ray, t)) discard;
    float slice = ray.slice;
    float half_depth = ray.half_depth;
    ivec2 pixel = ivec2(gl_FragCoord.xy);
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
        bool begins_here = part.x >= 0.0 && is_in_slab(ray, part.x); // then that belongs to the entry
        if (first.z >= slice && !begins_here && yields(slice, part, half_depth)) from = begin;
        to = min(t, first.z);
    }
    vec2 piece = kept(vec2(from, to), pixel);
    picture = light_between(ray.along, t, piece.x, piece.y);
}
)";

// A fragment is in the part whose ends it lies between; of a face it is clear which part it begins or ends.
std::string later_parts(int parts, bool edge) {
    std::string text;
    for (int i = 1; i < parts; ++i) {
        const std::string next = "texelFetch(part_" + std::to_string(i) + ", pixel, 0).xy";
        text += "{ vec2 next = " + next + ";\n";
        text += edge ? "if (gl_FrontFacing ? abs(next.x - t) < abs(part.x - t) : abs(next.y - t) < abs(part.y - t)) "
                       "part = next; }\n"
                     : "if (t > 0.5 * (part.y + next.x)) part = next; }\n";
    }
    if (parts == most_ray_parts && !edge) text += "if (t > part.y + half_depth) part = vec2(-never, never);\n";
    return text;
}

std::string with_parts(std::string body, int parts, const std::string& text) {
    const std::string word = "LATER_PARTS";
    body.replace(body.find(word), word.size(), text);
    std::string samplers;
    for (int i = 1; i < parts; ++i) samplers += "uniform sampler2D part_" + std::to_string(i) + ";\n";
    return samplers + body;
}

// Until there is one that the planes keep something of.
std::string next_parts_seen(int parts) {
    std::string text;
    for (int i = 1; i < parts; ++i) {
        const std::string part = std::to_string(i);
        text += "if (seen.x >= seen.y) seen = kept_of(texelFetch(part_" + part + ", pixel, 0).xy, kept);\n";
    }
    return text;
}

// A pixel that what is left of the mesh covers in part has so much of its light, or of a pixel's beside it whose ray
// met that.
constexpr const char* picture_fragment = R"(
uniform sampler2D volume;
uniform sampler2D covered;
uniform sampler2D limits;
uniform float has_covered;
uniform vec2 viewport;
uniform float opacity;
out vec4 picture;
bool misses(ivec2 pixel) { return texelFetch(limits, pixel, 0).a >= 1.0; }
vec2 beside(vec2 place) {
    ivec2 pixel = ivec2(place), last = textureSize(limits, 0) - 1;
    if (!misses(pixel)) return place;
    for (int reach = 1; reach <= 2; ++reach) // beside first, then across a corner
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (abs(x) + abs(y) == reach && !misses(clamp(pixel + ivec2(x, y), ivec2(0), last)))
                    return clamp(place + vec2(x, y), vec2(0.5), vec2(last) + 0.5);
    return place;
}
void main() {
    vec2 place = seen_from();
    float share = has_covered > 0.5 ? texelFetch(covered, ivec2(gl_FragCoord.xy), 0).r : 1.0;
    if (share > 0.0 && share < 1.0) place = beside(place);
    picture = texture(volume, place / viewport) * (share * opacity);
}
)";

std::string slab_defines(const SlabProgramKind& kind) {
    return std::string(version) + (kind.shaded ? "#define SHADED\n" : "") + (kind.clipped ? "#define CLIPPED\n" : "") +
           (kind.opaque ? "#define OPAQUE\n" : "") + "#define ROWS " + std::to_string(kind.table_rows) + ".0\n";
}

ShaderProgram make_slab_program(const Gl& gl, bool edge, const SlabProgramKind& kind) {
    const std::string defines = slab_defines(kind);
    return make_shader_program(
        gl, defines + slab_vertex,
        defines + depth + ray_uniforms + ray + light + light_between + ownership + clipping +
            with_parts(edge ? edge_fragment : slice_fragment, kind.parts, later_parts(kind.parts, edge)));
}

} // namespace

ShaderProgram make_part_program(const Gl& gl, bool first) {
    return make_shader_program(gl, std::string(version) + part_vertex,
                               std::string(version) + (first ? "" : "#define NEXT\n") + depth + part_fragment);
}

ShaderProgram make_kept_program(const Gl& gl) {
    return make_cover_program(gl, std::string(version) + ray_uniforms + kept_fragment);
}

ShaderProgram make_limits_program(const Gl& gl, int parts) {
    return make_cover_program(gl, std::string(version) + with_parts(limits_fragment, parts, next_parts_seen(parts)));
}

ShaderProgram make_limits_copy_program(const Gl& gl) {
    return make_cover_program(gl, std::string(version) + limits_copy_fragment);
}

ShaderProgram make_slice_program(const Gl& gl, const SlabProgramKind& kind) {
    return make_slab_program(gl, false, kind);
}
ShaderProgram make_inner_program(const Gl& gl, const SlabProgramKind& kind) {
    const std::string defines = slab_defines(kind);
    return make_shader_program(gl, defines + "#define INNER\n" + slab_vertex, defines + light + inner_fragment);
}
ShaderProgram make_edge_program(const Gl& gl, const SlabProgramKind& kind) { return make_slab_program(gl, true, kind); }

ShaderProgram make_volume_picture_program(const Gl& gl, bool per_sample) {
    return make_cover_program(gl, std::string(version) + seen_from_glsl(per_sample) + picture_fragment);
}

} // namespace ciel::render
