// The programs that draw points, as discs that are shaded like balls.
#include "render/surfaces/shader_parts.hpp"
#include "render/surfaces/shared_glsl.hpp"

namespace server::render {
namespace {

constexpr const char* point_vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 2) in float scalar;
layout(location = 3) in float size;
layout(location = 4) in vec4 color;
layout(location = 5) in vec3 style;
uniform mat4 view;
uniform mat4 projection;
uniform float point_pixels; // framebuffer pixels per picture pixel along a side
uniform vec4 clip[6];       // a plane clips only if the painter has enabled it
out float gl_ClipDistance[6];
out Disc {
    flat float value;
    flat float size;
    flat vec4 color;
    flat vec2 style;
} disc;
void main() {
    gl_Position = projection * (view * vec4(position, 1.0));
    for (int i = 0; i < 6; ++i) gl_ClipDistance[i] = dot(clip[i].xyz, position) + clip[i].w;
    disc.value = scalar - style.z;
    disc.size = max(size, 1.0) * point_pixels; // a smaller disc would miss most pixels
    disc.color = color;
    disc.style = style.xy;
    gl_PointSize = disc.size + 1.0; // one pixel more for a soft edge
}
)";

// A point that lies on no surface keeps its depth, except for a margin for rounding.
constexpr const char* free_glsl = R"(
uniform vec2 viewport;
float depth_of_disc(vec2 place) { return gl_FragCoord.z - 2.0 * least; }
)";

// A point on a surface is moved nearer to the eye than the lines that meet in it, so that it covers their ends.
constexpr const char* lying_glsl = R"(
uniform float point_pixels;
uniform float line_reach; // half the width of the widest line and half a pixel; 0 without lines
float depth_of_disc(vec2 place) {
    float give;
    float reach = disc.size * 0.5 + 0.5 + line_reach, slack = 0.75 + 0.5 * line_reach;
    return depth_on_surface(place, reach, slack, 12.0 * point_pixels, false, give) - least;
}
)";

constexpr const char* disc_glsl = R"(
in Disc {
    flat float value;
    flat float size;
    flat vec4 color;
    flat vec2 style;
} disc;
// Returns the fragment's offset from the disc's center, in pixels to the right and up.
vec2 from_center() { return (gl_PointCoord - 0.5) * (disc.size + 1.0) * vec2(1.0, -1.0); }
vec4 color_of_disc(vec2 place, float cover) {
    vec3 base = base_color(disc.value, disc.color.rgb, disc.style.x);
    if (disc.style.y > 0.5) base = lit_ball(base, place / (disc.size * 0.5 + 0.5));
    return vec4(base, disc.color.a * cover);
}
)";

// Opaque points have hard edges: a sample is covered or not, as at the edges of surfaces. A soft edge that writes depth
// would hide everything behind it. A soft edge that writes no depth would not hide objects that are drawn later.
constexpr const char* opaque_fragment = R"(
uniform int sample_count;
uniform vec2 sample_places[8]; // offsets from the middle of a pixel, in pixels
out vec4 picture;
void main() {
    vec2 place = from_center();
    int covered = 0;
    for (int i = 0; i < sample_count; ++i)
        if (length(place + sample_places[i]) <= disc.size * 0.5) covered |= 1 << i;
    if (covered == 0) discard;
#ifdef GL_ARB_sample_shading
    gl_SampleMask[0] = covered;
#endif
    gl_FragDepth = depth_of_disc(place);
    picture = color_of_disc(place, 1.0);
}
)";

// Opaque points have hard edges, because each soft edge would need another layer behind it. depth_of_disc() never moves
// a point away from the eye, so the first test may discard by gl_FragCoord.z.
constexpr const char* layer_fragment = R"(
layout(location = 0) out vec4 picture;
void main() {
    if (gl_FragCoord.z <= texelFetch(nearer, ivec2(gl_FragCoord.xy), 0).r) discard;
    vec2 place = from_center();
    float inside = disc.size * 0.5 - length(place);
    float cover = disc.color.a < 1.0 ? clamp(inside + 0.5, 0.0, 1.0) : step(0.0, inside);
    if (cover < 0.02) discard;
    float depth = depth_of_disc(place);
    if (!is_seen(depth)) discard;
#ifdef RECORDED
    if (hides_all(disc.color.a * cover)) record.x = -1.0;
#endif
    gl_FragDepth = depth;
    picture = color_of_disc(place, cover);
}
)";

constexpr const char* between_fragment = R"(
uniform sampler2D nearer;
uniform sampler2D farther; // depth of the layer behind the points; 0: nothing is visible there
out vec4 picture;
void main() {
    vec2 place = from_center();
    float cover = clamp(disc.size * 0.5 + 0.5 - length(place), 0.0, 1.0);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float last = texelFetch(farther, pixel, 0).r, first = texelFetch(nearer, pixel, 0).r;
    if (cover < 0.02 || last <= 0.0 || gl_FragCoord.z <= first) discard;
    float depth = depth_of_disc(place);
    if (depth <= first || depth > last) discard;
    picture = color_of_disc(place, cover);
    picture.rgb *= picture.a;
}
)";

Program make_program(const Gl& gl, const std::string& depth, const char* fragment, const std::string& before = "") {
    const std::string body = disc_glsl + depth + fragment;
    return link(gl, {{GL_VERTEX_SHADER, point_vertex}, {GL_FRAGMENT_SHADER, with_color_scale(body, before)}});
}

std::string lying() { return on_surface_glsl + lying_glsl; }

} // namespace

Program make_point_program(const Gl& gl) {
    return make_program(gl, lying(), opaque_fragment, "#extension GL_ARB_sample_shading : enable\n");
}

Program make_peeling_point_program(const Gl& gl, bool recorded) {
    return make_program(gl, lying(), layer_fragment, layer_macros(recorded));
}

Program make_point_between_program(const Gl& gl, bool on_surfaces) {
    return make_program(gl, on_surfaces ? lying() : depth_layers_glsl + std::string(free_glsl), between_fragment);
}

} // namespace server::render
