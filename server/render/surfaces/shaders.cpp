#include "render/surfaces/shader_parts.hpp"

#include "render/surfaces/ambient_occlusion_shaders.hpp"
#include "render/surfaces/shared_glsl.hpp"

namespace server::render {
namespace {

// For the most common primitives: one color, normals per vertex, no clip plane. Each interpolated number costs time
// in a software rasterizer, so only the normal is interpolated.
const std::string plain_vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 view;
uniform mat4 projection;
out vec3 eye_normal;
void main() {
    gl_Position = projection * (view * vec4(position, 1.0));
    eye_normal = mat3(view) * normal;
}
)";

const std::string plain_fragment = R"(
uniform vec4 look; // a pixel's ray is (xy of the pixel * look.xy + look.zw, -1)
uniform vec4 solid;
uniform float lit;
in vec3 eye_normal;
out vec4 picture;
void main() {
    picture = solid;
    if (lit > 0.5) {
        vec3 viewer = normalize(vec3(-(gl_FragCoord.xy * look.xy + look.zw), 1.0));
        float square = dot(eye_normal, eye_normal);
        vec3 n = square > 1e-12 ? eye_normal * inversesqrt(square) : viewer;
        picture.rgb = lit_surface(solid.rgb, seen_normal(n, viewer), viewer);
    }
}
)";

// is_seen() for lines drawn again after the volumes: only fragments in front of the volumes are visible. In a pixel's
// middle, a steep face may be nearer than a line on it, so a line may be behind by the face's rise over one pixel.
constexpr const char* before_volume_glsl = R"(
uniform float before_volume; // 1: only fragments in front of the volumes are visible
uniform sampler2D volume_limits;
float first_depth(ivec2 pixel) {
    return texelFetch(volume_limits, clamp(pixel, ivec2(0), textureSize(volume_limits, 0) - 1), 0).a;
}
bool is_seen(float depth) {
    if (before_volume < 0.5) return true;
    const float most = 5e-3; // limit of the slope, which is too large beside an outline
    ivec2 pixel = ivec2(gl_FragCoord.xy / viewport * vec2(textureSize(volume_limits, 0)));
    float own = first_depth(pixel), slope = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
        ivec2 beside = ivec2(1 - axis, axis);
        slope += min(max(abs(first_depth(pixel - beside) - own), abs(first_depth(pixel + beside) - own)), most);
    }
    return gl_FragCoord.z <= own + slope;
}
)";

const std::string triangle_fragment = R"(
uniform float parallel;
in)" + std::string(surface_block) + R"(;
layout(location = 0) out vec4 picture;
#ifdef OCCLUDED
uniform float occlusion_scale; // bounds' diagonal in units of the radius
#endif

void main() {
#ifdef PEELED
    if (!is_seen(gl_FragCoord.z)) discard;
#endif
    vec3 viewer = mix(normalize(-surface.place), vec3(0.0, 0.0, 1.0), parallel);
#ifdef NORMALS
    picture = vec4(facing_normal(surface.place, surface.normal, viewer), 1.0);
    return;
#endif
    vec3 base = base_color(surface.value, surface.color.rgb, surface.style.x);
    if (surface.style.y > 0.5) {
        base = lit_surface(base, facing_normal(surface.place, surface.normal, viewer), viewer);
#ifdef OCCLUDED
        base *= light_from_everywhere(-surface.place.z * occlusion_scale);
#endif
    }
    picture = vec4(base, surface.color.a);
}
)";

// slopes_fragment writes R: slope of a triangle, in window depth per pixel; G: slope limited by its extent in depth.
const std::string slopes_geometry = R"(#version 330 core
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
uniform vec4 clip[6];
out float gl_ClipDistance[6];
in)" + std::string(surface_block) +
                                    R"([];
flat out float extent;
void main() {
    float low = 1.0;
    float high = -1.0;
    for (int i = 0; i < 3; ++i) {
        vec4 place = gl_in[i].gl_Position;
        float depth = place.w > 0.0 ? place.z / place.w : -1.0; // -1: behind the eye
        low = min(low, depth);
        high = max(high, depth);
    }
    for (int i = 0; i < 3; ++i) {
        gl_Position = gl_in[i].gl_Position;
        for (int k = 0; k < 6; ++k) gl_ClipDistance[k] = dot(clip[k].xyz, surface[i].position) + clip[k].w;
        extent = 0.5 * (high - low);
        EmitVertex();
    }
    EndPrimitive();
}
)";

const std::string slopes_fragment = R"(#version 330 core
flat in float extent;
out vec4 picture;
void main() {
    float slope = length(vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)));
    picture = vec4(slope, min(slope, extent), 0.0, 0.0);
}
)";

// A line becomes a rectangle, because core profiles may refuse wide lines.
const std::string line_geometry = std::string("#version 330 core\n") + depth_layers_glsl + R"(
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
uniform vec4 clip[6];
out float gl_ClipDistance[6];
uniform vec2 viewport;
uniform float half_width;
in)" + std::string(surface_block) +
                                  R"([];
out Line {
    float value;
    noperspective float across;
    flat vec2 side; // unit vector in pixels, in which `across` grows
    flat float joint; // range of depth in which the segment overlaps others at its ends
    flat vec4 color;
    flat vec2 style;
} line;

// `along`: position between the two vertices, from 0 to 1.
void corner(vec4 end, float value, float along, vec2 offset, vec2 side, float across, float joint) {
    vec3 position = mix(surface[0].position, surface[1].position, along);
    for (int i = 0; i < 6; ++i) gl_ClipDistance[i] = dot(clip[i].xyz, position) + clip[i].w;
    gl_Position = end + vec4(offset / viewport * 2.0 * end.w, 0.0, 0.0);
    line.value = value;
    line.across = across;
    line.side = side;
    line.joint = joint;
    line.color = surface[0].color;
    line.style = surface[0].style;
    EmitVertex();
}

void main() {
    vec4 a = gl_in[0].gl_Position;
    vec4 b = gl_in[1].gl_Position;
    float value_a = surface[0].value;
    float value_b = surface[1].value;
    // in_a, in_b: negative behind the near plane. The line is cut there: a point behind the eye has no projection.
    float in_a = a.z + a.w;
    float in_b = b.z + b.w;
    float from = 0.0;
    float to = 1.0;
    if (in_a < 0.0 && in_b < 0.0) return;
    if (in_a < 0.0) {
        from = in_a / (in_a - in_b);
        a = mix(a, b, from);
        value_a = mix(value_a, value_b, from);
    } else if (in_b < 0.0) {
        to = in_a / (in_a - in_b);
        b = mix(a, b, to);
        value_b = mix(value_a, value_b, to);
    }
    vec2 along = (b.xy / b.w - a.xy / a.w) * viewport * 0.5;
    float pixels = length(along);
    float joint = joint_of_segment(a.z / a.w, b.z / b.w, half_width, pixels);
    along = pixels > 1e-6 ? along / pixels : vec2(1.0, 0.0);
    vec2 side = vec2(-along.y, along.x);
    float edge = half_width + 0.5;
    vec2 cap = along * half_width * 0.5; // lengthens both ends, so that segments that meet leave no notch
    corner(a, value_a, from, edge * side - cap, side, edge, joint);
    corner(a, value_a, from, -edge * side - cap, side, -edge, joint);
    corner(b, value_b, to, edge * side + cap, side, edge, joint);
    corner(b, value_b, to, -edge * side + cap, side, -edge, joint);
    EndPrimitive();
}
)";

constexpr const char* cover_glsl = R"(
uniform float cover_part; // 0: coverage; 1: coverage below one half, else 0; 2: 1 where it is one half or more, else 0
float cover_drawn(float cover) {
    if (cover_part > 1.5) return cover < 0.5 ? 0.0 : 1.0;
    return cover_part > 0.5 && cover >= 0.5 ? 0.0 : cover;
}
)";

constexpr const char* line_fragment = R"(
uniform float half_width;
in Line {
    float value;
    noperspective float across;
    flat vec2 side;
    flat float joint;
    flat vec4 color;
    flat vec2 style;
} line;
layout(location = 0) out vec4 picture;
#ifdef RECORDED
// Number of the primitives, from 1, for transparent lines: segments of one Primitives join where they meet. 0 for
// opaque lines.
uniform float number;
uniform float joining;    // 1: second pass, which joins segments
uniform sampler2D behind; // window depths of opaque surfaces, at which the layers end
#endif
void main() {
    float cover = cover_drawn(clamp(half_width + 0.5 - abs(line.across), 0.0, 1.0));
    if (cover < 0.02) discard; // an invisible edge must not write depth
    float give;
    float slack = 0.5 + 0.5 * half_width; // half a pixel, and the caps
    float depth = depth_on_surface(line.side * line.across, half_width + 0.5, slack, 6.0, true, give);
#ifdef RECORDED
    float reach = reach_of_joint(line.joint + give);
    if (!is_line_seen(number, depth, reach)) discard;
    if (joining > 0.5 && !is_of_own_line(number, depth, reach, texture(behind, gl_FragCoord.xy / viewport).r)) discard;
    record_line(number, line.color.a * cover, depth, reach);
#else
    if (!is_seen(depth)) discard;
#endif
    gl_FragDepth = depth;
    picture = vec4(base_color(line.value, line.color.rgb, line.style.x), line.color.a * cover);
}
)";

// `before`: definitions for depth_layers.glsl. `after`: is_seen(), unless depth_layers.glsl defines it.
Program make_line_program(const Gl& gl, const std::string& before, const std::string& after) {
    return link(gl, {{GL_VERTEX_SHADER, surface_vertex},
                     {GL_GEOMETRY_SHADER, line_geometry},
                     {GL_FRAGMENT_SHADER,
                      with_color_scale(std::string(cover_glsl) + line_fragment, before + on_surface_glsl + after)}});
}

} // namespace

Program make_triangle_program(const Gl& gl) {
    return link(gl, {{GL_VERTEX_SHADER, surface_vertex}, {GL_FRAGMENT_SHADER, with_color_scale(triangle_fragment)}});
}

Program make_plain_program(const Gl& gl) {
    return link(gl, {{GL_VERTEX_SHADER, plain_vertex},
                     {GL_FRAGMENT_SHADER, std::string("#version 330 core\n") + lighting_glsl + plain_fragment}});
}

Program make_peeling_program(const Gl& gl, bool recorded) {
    return link(
        gl, {{GL_VERTEX_SHADER, surface_vertex},
             {GL_FRAGMENT_SHADER, with_color_scale(triangle_fragment, layer_macros(recorded) + depth_layers_glsl)}});
}

Program make_peeling_line_program(const Gl& gl, bool recorded) {
    return make_line_program(gl, layer_macros(recorded), "");
}

Program make_normals_program(const Gl& gl) {
    return link(gl, {{GL_VERTEX_SHADER, surface_vertex},
                     {GL_FRAGMENT_SHADER, with_color_scale(triangle_fragment, "#define NORMALS\n")}});
}

Program make_slopes_program(const Gl& gl) {
    return link(gl, {{GL_VERTEX_SHADER, surface_vertex},
                     {GL_GEOMETRY_SHADER, slopes_geometry},
                     {GL_FRAGMENT_SHADER, slopes_fragment}});
}

Program make_occluded_program(const Gl& gl) {
    const std::string defines = std::string("#define OCCLUDED\n") + occluded_glsl;
    return link(
        gl, {{GL_VERTEX_SHADER, surface_vertex}, {GL_FRAGMENT_SHADER, with_color_scale(triangle_fragment, defines)}});
}

Program make_line_program(const Gl& gl) { return make_line_program(gl, "", before_volume_glsl); }

} // namespace server::render
