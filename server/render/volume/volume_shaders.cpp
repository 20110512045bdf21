#include "render/volume/volume_shaders.hpp"

#include "render/target/per_sample.hpp"

#include <string>

namespace server::render {
namespace {

constexpr const char* version = "#version 330 core\n";

constexpr const char* part_vertex = R"(
layout(location = 0) in vec3 position;
uniform mat4 transform;
invariant gl_Position;
void main() { gl_Position = transform * vec4(position, 1.0); }
)";

constexpr const char* depth = R"(
// Nearest depth, and difference from it to the farthest; (0, 0) for a perspective.
uniform vec2 parallel_depths;
float fragment_depth() {
    return parallel_depths.y > 0.0 ? parallel_depths.x + gl_FragCoord.z * parallel_depths.y : 1.0 / gl_FragCoord.w;
}
)";

// Finds an entry and an exit of a ray. In the first part of a ray, an entry behind the exit means that the eye is
// inside the mesh. The GL rounds the corners of triangles, so the depths of two coincident faces differ, most of all on
// steep faces. Therefore, if the eye is in the bounds, entries are moved farther away by the largest rounding error.
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
    if (last.x > last.y) last.x = -never; // an entry behind the exit: the eye is inside the mesh
    if (gl_FrontFacing ? t <= max(last.y - apart, last.x + rounding) : t <= last.y + rounding) discard;
    float entry = t;
#else
    float entry = t + eye_in_bounds * apart;
#endif
    part = gl_FrontFacing ? vec4(entry, never, 0.0, 0.0) : vec4(never, t, 0.0, 0.0);
}
)";

constexpr const char* ray_uniforms = R"(
uniform vec2 ray_corner; // change of a ray's eye-space xy per unit of depth, at the picture's corner
uniform vec2 ray_step;   // change of ray_corner per pixel
uniform vec2 side_corner; // eye-space xy of a ray at depth 0, at the picture's corner; 0 in a perspective
uniform vec2 side_step;
)";

constexpr const char* kept_fragment = R"(
uniform vec4 planes[6]; // in eye space; (0, 0, 0, 1) keeps everything
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
uniform vec2 depth_row; // projection[2][2] and projection[3][2]
uniform float parallel;
out vec4 limits;
const float never = 1e30;
// Returns the interval of `part` that the clip planes keep; it is empty if it begins behind its end.
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
    if (part.x > part.y) part.x = -never; // an entry behind the exit: the eye is inside the mesh
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

std::string next_parts_seen(int parts) {
    std::string text;
    for (int i = 1; i < parts; ++i) {
        const std::string part = std::to_string(i);
        text += "if (seen.x >= seen.y) seen = kept_of(texelFetch(part_" + part + ", pixel, 0).xy, kept);\n";
    }
    return text;
}

// For pictures in which one ray is used for several pixels. At an outline of an opaque surface, some of the rays around
// a pixel end at the surface and others pass it. The pixel uses the ray that ends nearest to the pixel's own depth. A
// pixel is at an outline if its depth differs by at least 1 % of the depth range from the depth interpolated between
// the rays. A thinner piece of a volume is not visible.
constexpr const char* seen_between_rays = R"(
uniform sampler2D opaque;
const float least_bend = 1e-2;
vec2 seen_from() {
    vec2 pixels = vec2(textureSize(opaque, 0)) / vec2(textureSize(volume, 0)); // pixels per ray
    vec2 place = gl_FragCoord.xy / pixels - 0.5, corner = floor(place), share = place - corner;
    float own = texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).r, between = 0.0, least = 2.0;
    vec2 nearest = corner;
    for (int i = 0; i < 4; ++i) {
        vec2 step = vec2(i & 1, i >> 1);
        vec2 ray = clamp(corner + step, vec2(0.0), vec2(textureSize(volume, 0) - 1));
        float z = texelFetch(opaque, ivec2((ray + 0.5) * pixels), 0).r;
        vec2 part = mix(1.0 - share, share, step);
        between += part.x * part.y * z;
        if (abs(z - own) < least) {
            least = abs(z - own);
            nearest = ray;
        }
    }
    return abs(between - own) < least_bend ? gl_FragCoord.xy : (nearest + 0.5) * pixels;
}
)";

// Only the covered part of a pixel gets light. A dense mesh is nearly opaque one pixel inward from its outline.
// Therefore the optical depth is assumed to increase linearly inward, by the difference between the rays of this pixel
// and the next pixel inward. If the ray of this pixel misses the mesh, the next two pixels are used.
constexpr const char* picture_fragment = R"(
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
    for (int reach = 1; reach <= 2; ++reach) // neighbors at a side first, then at a corner
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (abs(x) + abs(y) == reach && !misses(clamp(pixel + ivec2(x, y), ivec2(0), last)))
                    return clamp(place + vec2(x, y), vec2(0.5), vec2(last) + 0.5);
    return place;
}
const vec2 gauss_points = vec2(0.2113, 0.7887);
float loss_of(vec4 light) { return -log(1.0 - min(light.a, 0.9999)); }
float covered_at(ivec2 pixel) { return texelFetch(covered, clamp(pixel, ivec2(0), textureSize(covered, 0) - 1), 0).r; }
vec4 light_of_part(vec2 place, float share) {
    ivec2 pixel = ivec2(place), last = textureSize(limits, 0) - 1;
    vec2 rise = vec2(covered_at(pixel + ivec2(1, 0)) - covered_at(pixel - ivec2(1, 0)),
                     covered_at(pixel + ivec2(0, 1)) - covered_at(pixel - ivec2(0, 1)));
    ivec2 inward = ivec2(round(rise / max(max(abs(rise.x), abs(rise.y)), 1e-3)));
    ivec2 next = clamp(pixel + inward, ivec2(0), last), second = clamp(next + inward, ivec2(0), last);
    bool is_own = place == gl_FragCoord.xy;
    if (!is_own || next == pixel || misses(next)) return texture(volume, beside(place) / viewport);
    bool is_met = !misses(pixel);
    if (!is_met && misses(second)) return texelFetch(volume, next, 0);
    vec4 light = texelFetch(volume, is_met ? pixel : next, 0);
    vec4 inner = texelFetch(volume, is_met ? next : second, 0);
    float loss = loss_of(light), rate = loss_of(inner) - loss;
    vec2 ways = share * gauss_points - (is_met ? share - 0.5 : share + 0.5); // pixels inward from the ray of `light`
    vec2 opacity = 1.0 - exp(-max(loss + rate * ways, 0.0));
    vec4 hue = light.a > 0.01 ? light : inner;
    return hue * (dot(opacity, vec2(0.5)) / max(hue.a, 1e-6));
}
void main() {
    vec2 place = seen_from();
    float share = has_covered > 0.5 ? texelFetch(covered, ivec2(gl_FragCoord.xy), 0).r : 1.0;
    bool in_part = share > 0.0 && share < 1.0;
    picture = (in_part ? light_of_part(place, share) : texture(volume, place / viewport)) * (share * opacity);
}
)";

} // namespace

std::string with_parts(std::string body, int parts, const std::string& text) {
    const std::string word = "LATER_PARTS";
    body.replace(body.find(word), word.size(), text);
    std::string samplers;
    for (int i = 1; i < parts; ++i) samplers += "uniform sampler2D part_" + std::to_string(i) + ";\n";
    return samplers + body;
}

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

ShaderProgram make_volume_picture_program(const Gl& gl, RaysOfPicture rays) {
    const bool coarse = rays == RaysOfPicture::one_for_several_pixels;
    return make_cover_program(
        gl, std::string(version) + "uniform sampler2D volume;\n" +
                (coarse ? seen_between_rays : seen_from_glsl(rays == RaysOfPicture::one_for_samples)) +
                picture_fragment);
}

} // namespace server::render
