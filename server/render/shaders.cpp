#include "render/shaders.hpp"

#include "ciel/types.hpp"
#include "render/ambient_occlusion_shaders.hpp"
#include "render/color_glsl.hpp"
#include "render/lighting.hpp"

namespace ciel::render {
namespace {

// What the vertices tell lines, triangles and points.
const std::string surface_block = R"( Surface {
    vec3 place; // in the eye's axes, in units of the bounds' diagonal: derivatives of small scenes must not underflow
    vec3 normal;
    float value;
    flat vec4 color;
    flat vec2 style;
    vec3 position; // for the lines' clip distances
} surface)";

const std::string surface_vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float scalar;
layout(location = 4) in vec4 color;
layout(location = 5) in vec2 style;
uniform mat4 view;
uniform mat4 projection;
uniform float scale;
uniform float point_size;
uniform vec4 clip[6]; // counts only where the painter has enabled it
out float gl_ClipDistance[6];
out)" + surface_block + R"(;
void main() {
    vec4 place = view * vec4(position, 1.0);
    gl_Position = projection * place;
    for (int i = 0; i < 6; ++i) gl_ClipDistance[i] = dot(clip[i].xyz, position) + clip[i].w;
    gl_PointSize = point_size + 1.0; // room for a soft edge; counts for points only
    surface.place = place.xyz * scale;
    surface.normal = mat3(view) * normal;
    surface.value = scalar;
    surface.color = color;
    surface.style = style;
    surface.position = position;
}
)";

// The most common mesh: one colour, normals of its own, no clip plane. A software rasteriser pays for each number that
// is carried from the vertices to the pixels, so only the normal is; where a pixel looks, it knows itself.
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

constexpr const char* peeled_glsl = R"(
#define PEELED
uniform sampler2D nearer;
bool is_seen(float depth) { return depth > texelFetch(nearer, ivec2(gl_FragCoord.xy), 0).r; }
)";

// A pixel of a line or point is beside the place where that is: as deep as there, it would be buried where the surface
// under it rises. So it comes as much nearer. Surfaces that went back instead would go behind what is behind them, most
// of all at their outlines. How a surface rises is what two steps to one side agree on, for one may be over an outline.
constexpr const char* on_surface_glsl = R"(
uniform vec2 viewport;
uniform sampler2D opaque_depth; // of the window, of what is opaque, in the picture's pixels
uniform sampler2D sheet_slopes; // depth a pixel of the steepest transparent surface
const float least = 5e-7;       // of 24 bits the last few, and what rounding takes
const float most_beside = 6.0;  // pixels: farther off it would come before what is well before it
float opaque_at(ivec2 pixel) {
    return texelFetch(opaque_depth, clamp(pixel, ivec2(0), textureSize(opaque_depth, 0) - 1), 0).r;
}
float smaller(float a, float b) { return abs(a) < abs(b) ? a : b; }
float rise_along(ivec2 pixel, ivec2 axis) {
    float own = opaque_at(pixel), next = opaque_at(pixel + axis), last = opaque_at(pixel - axis);
    float ahead = smaller(next - own, opaque_at(pixel + 2 * axis) - next);
    float behind = smaller(own - last, last - opaque_at(pixel - 2 * axis));
    return abs(ahead) > abs(behind) ? ahead : behind;
}
// `beside`: the place, from that of the line or point, at most `reach` away; `slack`: by how much that is unsure. Pixels.
// `back`: whether it may go back, so that all lines on one surface are as deep. `give`: by how much they may yet differ.
float depth_on_surface(vec2 beside, float reach, float slack, bool back, out float give) {
    vec2 size = vec2(textureSize(opaque_depth, 0));
    beside *= min(1.0, most_beside / (reach + slack));
    ivec2 pixel = ivec2(gl_FragCoord.xy / viewport * size);
    vec2 rise = vec2(rise_along(pixel, ivec2(1, 0)), rise_along(pixel, ivec2(0, 1))) * size / viewport;
    float shift = dot(rise, beside);
    float depth = gl_FragCoord.z + (back ? shift : min(shift, 0.0)) - slack * length(rise) - least;
    give = 0.0;
    if (depth > opaque_at(pixel)) return depth; // hidden, whatever sheets are there
    vec2 sheets = vec2(textureSize(sheet_slopes, 0)) / viewport;
    pixel = ivec2(gl_FragCoord.xy * sheets);
    float slope = 0.0; // of those beside as well: one that ends within the pixel may have missed its middle
    for (int i = 0; i < 9; ++i)
        slope = max(slope, texelFetch(sheet_slopes, clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0),
                                                          textureSize(sheet_slopes, 0) - 1), 0).r);
    give = min(reach, most_beside) * slope * sheets.x;
    return min(depth, gl_FragCoord.z - min(reach + slack, most_beside) * slope * sheets.x - least);
}
)";

// The same where lines of less than full opacity are among the layers. Segments that meet in a joint lie over each
// other there, and each would take its share of the light: so the last line at a pixel is passed on from layer to
// layer, and what is of the same mesh and as deep, within what either may rise in a joint, is the same line. Of its
// segments the nearest is the layer's; drawn a second time, they leave what they cover most of the pixel with.
constexpr const char* recorded_glsl = R"(
#define PEELED
#define RECORDED
uniform sampler2D nearer;
uniform sampler2D nearer_lines;
uniform sampler2D own_lines; // of the layer itself, the second time
uniform sampler2D behind;    // window depths of what is opaque, as the layers end on it
layout(location = 1) out vec2 record; // number of the last line, and how far back it is that; -1: nothing is seen behind
bool is_seen(float depth) {
    record = texelFetch(nearer_lines, ivec2(gl_FragCoord.xy), 0).rg;
    return record.x >= 0.0 && depth > texelFetch(nearer, ivec2(gl_FragCoord.xy), 0).r;
}
)";

// Of lines and points, which are drawn after the volumes too, then only what is in front of them. A line on the
// boundary is, though in the middle of a pixel a steep face may come before it: so a pixel's slope behind counts.
constexpr const char* before_volume_glsl = R"(
uniform float before_volume; // 1: only what is in front of the volume
uniform sampler2D volume_limits;
float first_depth(ivec2 pixel) {
    return texelFetch(volume_limits, clamp(pixel, ivec2(0), textureSize(volume_limits, 0) - 1), 0).a;
}
bool is_seen(float depth) {
    if (before_volume < 0.5) return true;
    const float most = 5e-3; // beside an outline
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
in)" + surface_block + R"(;
layout(location = 0) out vec4 picture;
#ifdef OCCLUDED
uniform float occlusion_scale; // bounds' diagonal in units of the radius
#endif

vec3 facing_normal(vec3 viewer) {
    vec3 plane = cross(dFdx(surface.place), dFdy(surface.place));
    float plane_length = length(plane);
    float normal_length = length(surface.normal);
    if (normal_length > 1e-6) return seen_normal(surface.normal / normal_length, viewer);
    if (plane_length <= 1e-30) return viewer; // a sliver without a plane of its own: never black
    return plane / (dot(plane, viewer) < 0.0 ? -plane_length : plane_length);
}

void main() {
#ifdef PEELED
    if (!is_seen(gl_FragCoord.z)) discard;
#endif
#ifdef SLOPES
    picture = vec4(length(vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z))));
    return;
#endif
    vec3 viewer = mix(normalize(-surface.place), vec3(0.0, 0.0, 1.0), parallel);
#ifdef NORMALS
    picture = vec4(facing_normal(viewer), 1.0);
    return;
#endif
    vec3 base = base_color(surface.value, surface.color.rgb, surface.style.x);
    if (surface.style.y > 0.5) {
        base = lit_surface(base, facing_normal(viewer), viewer);
#ifdef OCCLUDED
        base *= light_from_everywhere(-surface.place.z * occlusion_scale);
#endif
    }
    picture = vec4(base, surface.color.a);
}
)";

// A line becomes a rectangle of the asked width in pixels with soft edges: core profiles may refuse wide lines.
const std::string line_geometry = R"(#version 330 core
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
uniform vec4 clip[6];
out float gl_ClipDistance[6];
uniform vec2 viewport;
uniform float half_width;
in)" + surface_block + R"([];
out Line {
    float value;
    noperspective float across;
    flat vec2 side; // of unit length, in pixels: where `across` runs to
    flat float joint; // depth within which it meets others
    flat vec4 color;
    flat vec2 style;
} line;

// `along`: where between the two vertices.
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
    float in_a = a.z + a.w; // behind the nearest plane when negative: cut there, a point behind the eye has no pixel
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
    float joint = abs(b.z / b.w - a.z / a.w) * 0.5 * min(1.0, (half_width + 1.0) / max(pixels, 1e-6));
    along = pixels > 1e-6 ? along / pixels : vec2(1.0, 0.0);
    vec2 side = vec2(-along.y, along.x);
    float edge = half_width + 0.5;
    vec2 cap = along * half_width * 0.5; // so that lines that meet leave no notch
    corner(a, value_a, from, edge * side - cap, side, edge, joint);
    corner(a, value_a, from, -edge * side - cap, side, -edge, joint);
    corner(b, value_b, to, edge * side + cap, side, edge, joint);
    corner(b, value_b, to, -edge * side + cap, side, -edge, joint);
    EndPrimitive();
}
)";

// Of lines and points: how much of a pixel is theirs, of the part that is being drawn.
constexpr const char* cover_glsl = R"(
uniform float cover_part; // 0: all; 1: only where it is less than half; 2: only where it is more, and that is then whole
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
uniform float number;  // of lines that are the same where they meet; 0: of none
uniform float joining; // 1: the second time
#endif
void main() {
    float cover = cover_drawn(clamp(half_width + 0.5 - abs(line.across), 0.0, 1.0));
    if (cover < 0.02) discard; // else an unseen edge would still hide what is behind it
    float give;
    float slack = 0.5 + 0.5 * half_width; // a pixel's half, and the caps
    float depth = depth_on_surface(line.side * line.across, half_width + 0.5, slack, true, give);
    if (!is_seen(depth)) discard;
#ifdef RECORDED
    float joint = 3.0 * (line.joint + give + least);
    if (number > 0.5 && record.x == number && depth - joint < record.y) discard;
    if (joining > 0.5) {
        vec2 own = texelFetch(own_lines, ivec2(gl_FragCoord.xy), 0).rg;
        if (own.x != number || depth - joint > own.y ||
            depth > texture(behind, gl_FragCoord.xy / viewport).r)
            discard;
    }
    record = vec2(number > 0.5 ? number : line.color.a * cover > 0.998 ? -1.0 : 0.0, depth + joint);
#endif
    gl_FragDepth = depth;
    picture = vec4(base_color(line.value, line.color.rgb, line.style.x), line.color.a * cover);
}
)";

// A point is a disc with soft edges, shaded as the ball that it stands for.
const std::string point_fragment = R"(
uniform float point_size;
in)" + surface_block + R"(;
out vec4 picture;
void main() {
    vec2 from_center = (gl_PointCoord - 0.5) * (point_size + 1.0);
    float give;
    gl_FragDepth = depth_on_surface(vec2(from_center.x, -from_center.y), point_size * 0.5 + 0.5, 0.75, false, give);
    if (!is_seen(gl_FragDepth)) discard;
    float radius = length(from_center);
    float cover = cover_drawn(clamp(point_size * 0.5 + 0.5 - radius, 0.0, 1.0));
    if (cover < 0.02) discard;
    vec3 base = base_color(surface.value, surface.color.rgb, surface.style.x);
    if (surface.style.y > 0.5) base = lit_ball(base, from_center / (point_size * 0.5 + 0.5));
    picture = vec4(base, surface.color.a * cover);
}
)";

void add_shader(const Gl& gl, GLuint program, GLenum kind, const std::string& source) {
    const GLuint shader = gl.CreateShader(kind);
    const char* text = source.c_str();
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    GLint is_compiled = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
    if (is_compiled == 0) {
        std::vector<char> log(4096);
        gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw Error("the GL driver refuses a shader: " + std::string(log.data()));
    }
    gl.AttachShader(program, shader);
}

Program link(const Gl& gl, const std::vector<Stage>& stages) {
    Program program;
    program.id = link_stages(gl, stages);
    const auto uniform = [&](const char* name) { return gl.GetUniformLocation(program.id, name); };
    program.view = uniform("view");
    program.projection = uniform("projection");
    program.scale = uniform("scale");
    program.parallel = uniform("parallel");
    program.scale_colors = uniform("scale_colors");
    program.scale_rules = uniform("scale_rules");
    program.lights = uniform("lights");
    program.look = uniform("look");
    program.solid = uniform("solid");
    program.lit = uniform("lit");
    program.clip = uniform("clip");
    program.point_size = uniform("point_size");
    program.viewport = uniform("viewport");
    program.half_width = uniform("half_width");
    program.opaque_depth = uniform("opaque_depth");
    program.sheet_slopes = uniform("sheet_slopes");
    program.before_volume = uniform("before_volume");
    program.volume_limits = uniform("volume_limits");
    program.cover_part = uniform("cover_part");
    program.nearer = uniform("nearer");
    program.nearer_lines = uniform("nearer_lines");
    program.own_lines = uniform("own_lines");
    program.behind = uniform("behind");
    program.number = uniform("number");
    program.joining = uniform("joining");
    program.occlusion = uniform("occlusion");
    program.occlusion_stride = uniform("occlusion_stride");
    program.occlusion_strength = uniform("occlusion_strength");
    program.occlusion_scale = uniform("occlusion_scale");
    return program;
}

std::string with_color_scale(const std::string& body, const char* defines = "") {
    return std::string("#version 330 core\n") + defines + color_scale_glsl + lighting_glsl + body;
}

Program make_line_program(const Gl& gl, const char* visibility) {
    return link(gl, {{GL_VERTEX_SHADER, surface_vertex},
                     {GL_GEOMETRY_SHADER, line_geometry},
                     {GL_FRAGMENT_SHADER, with_color_scale(std::string(cover_glsl) + line_fragment,
                                                           (std::string(on_surface_glsl) + visibility).c_str())}});
}

} // namespace

const char* const cover_vertex = R"(#version 330 core
void main() {
    vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
)";

GLuint link_stages(const Gl& gl, const std::vector<Stage>& stages) {
    const GLuint program = gl.CreateProgram();
    for (const auto& [kind, source] : stages) add_shader(gl, program, kind, source);
    gl.LinkProgram(program);
    GLint is_linked = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &is_linked);
    if (is_linked == 0) {
        std::vector<char> log(4096);
        gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw Error("the GL driver refuses a program: " + std::string(log.data()));
    }
    return program;
}

Program make_triangle_program(const Gl& gl) {
    return link(gl, {{GL_VERTEX_SHADER, surface_vertex}, {GL_FRAGMENT_SHADER, with_color_scale(triangle_fragment)}});
}

Program make_plain_program(const Gl& gl) {
    return link(gl, {{GL_VERTEX_SHADER, plain_vertex},
                     {GL_FRAGMENT_SHADER, std::string("#version 330 core\n") + lighting_glsl + plain_fragment}});
}

Program make_point_program(const Gl& gl) {
    return link(gl,
                {{GL_VERTEX_SHADER, surface_vertex},
                 {GL_FRAGMENT_SHADER, with_color_scale(cover_glsl + point_fragment,
                                                       (std::string(on_surface_glsl) + before_volume_glsl).c_str())}});
}

Program make_peeling_program(const Gl& gl, bool recorded) {
    return link(gl,
                {{GL_VERTEX_SHADER, surface_vertex},
                 {GL_FRAGMENT_SHADER, with_color_scale(triangle_fragment, recorded ? recorded_glsl : peeled_glsl)}});
}

Program make_peeling_line_program(const Gl& gl, bool recorded) {
    return make_line_program(gl, recorded ? recorded_glsl : peeled_glsl);
}

Program make_normals_program(const Gl& gl) {
    return link(gl, {{GL_VERTEX_SHADER, surface_vertex},
                     {GL_FRAGMENT_SHADER, with_color_scale(triangle_fragment, "#define NORMALS\n")}});
}

Program make_slopes_program(const Gl& gl) {
    return link(gl, {{GL_VERTEX_SHADER, surface_vertex},
                     {GL_FRAGMENT_SHADER, with_color_scale(triangle_fragment, "#define SLOPES\n")}});
}

Program make_occluded_program(const Gl& gl) {
    const std::string defines = std::string("#define OCCLUDED\n") + occluded_glsl;
    return link(gl, {{GL_VERTEX_SHADER, surface_vertex},
                     {GL_FRAGMENT_SHADER, with_color_scale(triangle_fragment, defines.c_str())}});
}

Program make_line_program(const Gl& gl) { return make_line_program(gl, before_volume_glsl); }

} // namespace ciel::render
