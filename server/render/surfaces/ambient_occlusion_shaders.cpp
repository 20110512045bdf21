#include "render/surfaces/ambient_occlusion_shaders.hpp"

namespace server::render {
namespace {

constexpr const char* occlusion_fragment = R"(#version 330 core
uniform sampler2D depths;  // window depths of opaque surfaces, 1 where there is none
uniform sampler2D normals; // in eye space, facing the viewer
uniform int stride;       // pixels of `depths` per output pixel along a side
uniform int lines;
uniform int steps;        // samples along each half of a line
uniform float parallel;
uniform vec2 corner;      // eye-space xy of the picture's lower left corner; perspective: at depth 1
uniform vec2 pixel;       // eye-space xy from one pixel to the next; perspective: at depth 1
uniform vec2 depth_row;   // (projection[2][2], projection[3][2]) for lengths in units of the radius
uniform float reach;      // radius in pixels; perspective: at depth 1
uniform float most_reach; // limit of the radius in pixels
out vec4 found;
const float half_turn = 3.14159265358979;
const float quarter_turn = half_turn / 2.0;

float window_at(ivec2 at) {
    ivec2 size = textureSize(depths, 0);
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) return 1.0;
    return texelFetch(depths, at, 0).r;
}

vec3 place_of(ivec2 at, float window) {
    float ndc = 2.0 * window - 1.0;
    float depth = parallel > 0.5 ? (depth_row.y - ndc) / depth_row.x : depth_row.y / (ndc + depth_row.x);
    return vec3((corner + pixel * (vec2(at) + 0.5)) * (parallel > 0.5 ? 1.0 : depth), -depth);
}

// Returns the change of depth on the plane with normal n, from this ray to the ray that differs by `side` in xy.
float rise(vec3 ray, float depth, vec3 n, vec2 side) {
    float away = dot(n.xy, side);
    if (parallel > 0.5) return away / max(n.z, 0.01);
    float straight = max(-dot(n, ray), 0.01);
    return depth * away / max(straight - away, 0.01);
}

// Returns the cosine of the angle between the viewer and the horizon along one half of a line. `low`: cosine of the
// angle between the viewer and the surface's own plane.
float horizon(ivec2 at, vec3 place, vec3 n, vec3 viewer, vec2 along, float length_of_half, float share, float low,
              float shrink) {
    float highest = low;
    ivec2 last = ivec2(0);
    for (int i = 0; i < steps; ++i) {
        float t = (float(i) + share) / float(steps);
        ivec2 offset = ivec2(round(along * max(t * t * length_of_half, float(i) + 1.0)));
        if (offset == last) continue;
        last = offset;
        float window = window_at(at + offset);
        if (window >= 1.0) continue;
        vec3 there = place_of(at + offset, window) - place;
        float squared = dot(there, there) * shrink * shrink;
        vec3 direction = there * inversesqrt(max(dot(there, there), 1e-20));
        // A sample that is only slightly above the plane is on the next facet of the same surface, and is ignored.
        float counts = max(1.0 - squared, 0.0) * smoothstep(0.02, 0.2, dot(n, direction));
        highest = max(highest, mix(low, dot(direction, viewer), counts));
    }
    return highest;
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 at = min(here * stride, textureSize(depths, 0) - 1);
    float window = window_at(at);
    if (window >= 1.0) {
        found = vec4(1.0, 1e30, 0.0, 0.0);
        return;
    }
    vec3 place = place_of(at, window);
    vec3 viewer = parallel > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(-place);
    vec3 n = normalize(texelFetch(normals, at, 0).xyz);
    vec3 ray = place / -place.z;
    found = vec4(1.0, -place.z, rise(ray, -place.z, n, vec2(pixel.x, 0.0) * float(stride)),
                 rise(ray, -place.z, n, vec2(0.0, pixel.y) * float(stride)));

    float pixels = reach / (parallel > 0.5 ? 1.0 : -place.z);
    float shrink = max(pixels / most_reach, 1.0); // factor by which the radius is reduced
    pixels /= shrink;
    if (pixels < 1.5) return;
    int x = here.x & 3, y = here.y & 3;
    float turn = float((4 * x + 11 * y) & 15) / 16.0;
    float share = (float((5 * x + 2 * y) & 3) * 4.0 + float((x + 3 * y) & 3) + 0.5) / 16.0;
    float seen = 0.0;
    float all = 0.0;
    for (int i = 0; i < lines; ++i) {
        float angle = (float(i) + turn) * half_turn / float(lines);
        vec2 along = vec2(cos(angle), sin(angle));
        vec3 across = vec3(along, 0.0) - dot(vec3(along, 0.0), viewer) * viewer;
        vec3 axis = normalize(cross(across, viewer));
        vec3 flat_n = n - axis * dot(n, axis);
        float weight = length(flat_n);
        float cosine = clamp(dot(flat_n, viewer) / max(weight, 1e-6), 0.0, 1.0);
        float tilt = sign(dot(across, flat_n)) * acos(cosine);
        float ahead = horizon(at, place, n, viewer, along, pixels, share, cos(tilt + quarter_turn), shrink);
        float behind = horizon(at, place, n, viewer, -along, pixels, share, cos(tilt - quarter_turn), shrink);
        float to = acos(clamp(ahead, -1.0, 1.0));
        float from = -acos(clamp(behind, -1.0, 1.0));
        float sine = sin(tilt);
        seen += weight * 0.25 *
                (2.0 * cosine + 2.0 * (from + to) * sine - cos(2.0 * from - tilt) - cos(2.0 * to - tilt));
        all += weight * (cosine + tilt * sine);
    }
    found.r = all > 0.0 ? clamp(seen / all, 0.0, 1.0) : 1.0;
}
)";

constexpr const char* even_light_fragment = R"(#version 330 core
uniform sampler2D found;
out vec4 even;
void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(found, 0) - 1;
    vec4 own = texelFetch(found, here, 0);
    float sum = 0.0;
    float weights = 0.0;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) { // mean of the four 4 x 4 windows around this texel
            float ways = (abs(x) == 2 ? 0.5 : 1.0) * (abs(y) == 2 ? 0.5 : 1.0);
            vec4 other = texelFetch(found, clamp(here + ivec2(x, y), ivec2(0), last), 0);
            float off = abs(other.g - own.g - own.b * float(x) - own.a * float(y));
            float weight = ways * max(1.0 - off * 10.0, 0.0);
            sum += weight * other.r;
            weights += weight;
        }
    even = vec4(weights > 0.0 ? sum / weights : own.r, own.g, 0.0, 0.0);
}
)";

} // namespace

const char* const occluded_glsl = R"(
uniform sampler2D occlusion;    // R: share of the light, G: depth
uniform float occlusion_stride; // picture pixels per texel of `occlusion` along a side
uniform float occlusion_strength;

float light_from_everywhere(float depth) {
    vec2 slope = vec2(dFdx(depth), dFdy(depth)) * occlusion_stride;
    vec2 at = (gl_FragCoord.xy - 0.5) / occlusion_stride;
    ivec2 middle = ivec2(round(at));
    ivec2 last = textureSize(occlusion, 0) - 1;
    float sum = 0.0;
    float weights = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 texel = clamp(middle + ivec2(x, y), ivec2(0), last);
            vec2 far = vec2(middle + ivec2(x, y)) - at;
            vec2 near = max(1.5 - abs(far), 0.0);
            vec2 found = texelFetch(occlusion, texel, 0).rg;
            // `off` is large for texels of another surface. The term with 1e-3 gives a small weight to texels of similar
            // depth. It is needed where no texel fits, as on the steep rim of a ball: there the slope differs from
            // pixel to pixel.
            float off = abs(found.g - depth - dot(slope, far));
            float weight = near.x * near.y * (max(1.0 - off * 10.0, 0.0) + 1e-3 * max(1.0 - off, 0.0));
            sum += weight * found.r;
            weights += weight;
        }
    return weights > 0.0 ? pow(sum / weights, occlusion_strength) : 1.0;
}
)";

ShaderProgram make_occlusion_program(const Gl& gl) { return make_cover_program(gl, occlusion_fragment); }
ShaderProgram make_even_light_program(const Gl& gl) { return make_cover_program(gl, even_light_fragment); }

} // namespace server::render
