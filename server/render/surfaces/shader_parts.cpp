#include "render/surfaces/shader_parts.hpp"

#include "ciel/types.hpp"
#include "render/surfaces/shared_glsl.hpp"

namespace server::render {

const char* const surface_block = R"( Surface {
    // In eye space, in units of the bounds' diagonal, so that derivatives of small scenes do not underflow.
    vec3 place;
    vec3 normal;
    float value;
    flat vec4 color;
    flat vec2 style;
    vec3 position; // for clip distances in geometry shaders
} surface)";

const std::string surface_vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float scalar;
layout(location = 4) in vec4 color;
layout(location = 5) in vec3 style;
uniform mat4 view;
uniform mat4 projection;
uniform float scale;
uniform vec4 clip[6]; // a plane clips only if the painter has enabled it
out float gl_ClipDistance[6];
out)" + std::string(surface_block) +
                                   R"(;
void main() {
    vec4 place = view * vec4(position, 1.0);
    gl_Position = projection * place;
    for (int i = 0; i < 6; ++i) gl_ClipDistance[i] = dot(clip[i].xyz, position) + clip[i].w;
    surface.place = place.xyz * scale;
    surface.normal = mat3(view) * normal;
    surface.value = scalar - style.z;
    surface.color = color;
    surface.style = style.xy;
    surface.position = position;
}
)";

// depth_on_surface() moves a line or point nearer to the eye by the rise of its surface from the center of the line or
// point to the pixel, so that the surface does not hide the pixel. If surfaces were pushed back instead, objects behind
// a surface would hide it at outlines. The smaller of two depth steps is used, because one may cross an outline.
const std::string on_surface_glsl = std::string(depth_layers_glsl) + R"(
uniform vec2 viewport;
uniform float on_opaque; // 1: lies on an opaque surface; sheet_slopes is not used
// Window depths of opaque surfaces, at the picture's resolution.
uniform sampler2D opaque_depth;
// Slopes of transparent surfaces ("sheets"). R: largest slope, in depth per pixel; G: largest slope limited by its triangle's
// extent in depth.
uniform sampler2D sheet_slopes;
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
// Returns the slope of transparent surfaces from 3 x 3 pixels, because a surface that ends within a pixel may not cover
// the middle of the pixel. At an outline, a face that is seen edge-on has a very large slope in single pixels or rows of
// pixels. Therefore the result is the larger of two numbers: the fourth largest of the nine slopes, and the largest
// slope that is limited by the extent of its triangle.
float slope_around(ivec2 pixel) {
    vec4 steepest = vec4(0.0);
    float most = 0.0;
    for (int i = 0; i < 9; ++i) {
        vec2 found = texelFetch(sheet_slopes, clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0),
                                                    textureSize(sheet_slopes, 0) - 1), 0).rg;
        float slope = found.x;
        most = max(most, found.y);
        if (slope > steepest.x) steepest = vec4(slope, steepest.xyz);
        else if (slope > steepest.y) steepest.yzw = vec3(slope, steepest.yz);
        else if (slope > steepest.z) steepest.zw = vec2(slope, steepest.z);
        else steepest.w = max(steepest.w, slope);
    }
    return max(steepest.w, most);
}
// Returns the depth of a fragment at the offset `beside` from the middle of its line or point.
// `reach`: largest length of `beside`. `slack`: uncertainty of `beside`. All lengths are in pixels.
// `most`: upper limit of reach + slack. With more, the fragment would be moved in front of nearer objects.
// `back`: the depth may also grow, so that all lines on one surface get the same depth.
// `give`: largest difference that may remain between the depths of two lines on one surface.
float depth_on_surface(vec2 beside, float reach, float slack, float most, bool back, out float give) {
    vec2 size = vec2(textureSize(opaque_depth, 0));
    beside *= min(1.0, most / (reach + slack));
    ivec2 pixel = ivec2(gl_FragCoord.xy / viewport * size);
    vec2 rise = vec2(rise_along(pixel, ivec2(1, 0)), rise_along(pixel, ivec2(0, 1))) * size / viewport;
    float shift = dot(rise, beside);
    float depth = gl_FragCoord.z + (back ? shift : min(shift, 0.0)) - slack * length(rise) - least;
    give = 0.0;
    if (on_opaque > 0.5 || depth > opaque_at(pixel)) return depth; // transparent surfaces do not matter
    vec2 sheets = vec2(textureSize(sheet_slopes, 0)) / viewport;
    pixel = ivec2(gl_FragCoord.xy * sheets);
    float slope = slope_around(pixel) * sheets.x;
    give = min(reach, most) * slope;
    return min(depth, gl_FragCoord.z - min(reach + slack, most) * slope - least);
}
)";

std::string layer_macros(bool recorded) {
    return recorded ? "#define PEELED\n#define RECORDED\n#define JOINING\n" : "#define PEELED\n";
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
    program.point_pixels = uniform("point_pixels");
    program.farther = uniform("farther");
    program.viewport = uniform("viewport");
    program.half_width = uniform("half_width");
    program.on_opaque = uniform("on_opaque");
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
    program.line_reach = uniform("line_reach");
    program.sample_count = uniform("sample_count");
    program.sample_places = uniform("sample_places");
    program.occlusion = uniform("occlusion");
    program.occlusion_stride = uniform("occlusion_stride");
    program.occlusion_strength = uniform("occlusion_strength");
    program.occlusion_scale = uniform("occlusion_scale");
    return program;
}

std::string with_color_scale(const std::string& body, const std::string& defines) {
    return "#version 330 core\n" + defines + color_scale_glsl + lighting_glsl + body;
}

} // namespace server::render
