#include "render/surfaces/peeling_shaders.hpp"

#include "render/surfaces/shared_glsl.hpp"
#include "render/target/per_sample.hpp"

namespace server::render {
namespace {

// At an outline, the larger of two depth differences is between two surfaces, so `rise` uses the smaller one.
constexpr const char* kept_to_outlines_fragment = R"(#version 330 core
uniform sampler2D opaque;
uniform sampler2D middles; // window depths at the middles of picture pixels
const float least_step = 1e-2; // smallest depth step of an outline; the same as least_bend in per_sample.cpp
float middle_at(ivec2 pixel) { return texelFetch(middles, clamp(pixel, ivec2(0), textureSize(middles, 0) - 1), 0).r; }
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) / 2;
    float own = texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).r, middle = middle_at(pixel);
    float rise = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
        ivec2 beside = ivec2(1 - axis, axis);
        rise += min(abs(middle_at(pixel - beside) - middle), abs(middle_at(pixel + beside) - middle));
    }
    gl_FragDepth = abs(own - middle) > least_step + rise ? min(middle + rise, 1.0) : own;
}
)";

constexpr const char* depth_copy_fragment = R"(
uniform sampler2D opaque;
uniform sampler2D sum; // A: transmittance of the nearer layers
uniform vec2 viewport;
void main() {
    float through = texelFetch(sum, ivec2(gl_FragCoord.xy), 0).a;
    gl_FragDepth = start_of_layer(texture(opaque, gl_FragCoord.xy / viewport).r, through);
}
)";

constexpr const char* layer_sum_fragment = R"(
uniform sampler2D layer;
uniform sampler2D volumes;
uniform sampler2D depths; // window depths of the layer
uniform int factor;       // layer pixels per pixel of `volumes` along a side
out vec4 picture;
float depth_of_ray(ivec2 pixel) { return texelFetch(depths, factor * pixel + factor / 2, 0).r; }
// Returns the pixel of `volumes` whose ray ended nearest to the depth of this layer pixel. At an outline of the layer,
// the ray of this picture pixel may have ended on another surface.
ivec2 pixel_of_volumes() {
    ivec2 here = ivec2(gl_FragCoord.xy), pixel = here / factor, found = pixel;
    ivec2 side = (here & 1) * 2 - 1, last = textureSize(volumes, 0) - 1;
    float own = texelFetch(depths, here, 0).r;
    float off = abs(depth_of_ray(pixel) - own);
    for (int i = 1; i < 4 && off > 2e-3; ++i) {
        ivec2 other = clamp(pixel + side * ivec2(i & 1, i >> 1), ivec2(0), last);
        float other_off = abs(depth_of_ray(other) - own);
        if (other_off < off) {
            off = other_off;
            found = other;
        }
    }
    return min(found, last);
}
void main() {
    vec4 surface = texelFetch(layer, ivec2(gl_FragCoord.xy), 0);
    vec4 volume = texelFetch(volumes, pixel_of_volumes(), 0);
    picture = light_of_layer(surface, volume);
}
)";

// If layers have 2 x 2 pixels per picture pixel, the texture filter of `sum` returns the mean of these pixels.
constexpr const char* layers_picture_fragment = R"(
uniform sampler2D sum;
uniform sampler2D volumes;
uniform vec2 viewport;
out vec4 picture;
void main() {
    vec2 place = seen_from() / viewport;
    picture = light_of_all(texture(sum, place), texture(volumes, place));
}
)";

std::string with_depth_layers(const std::string& body) {
    return std::string("#version 330 core\n") + depth_layers_glsl + body;
}

} // namespace

ShaderProgram make_kept_to_outlines_program(const Gl& gl) { return make_cover_program(gl, kept_to_outlines_fragment); }
ShaderProgram make_depth_copy_program(const Gl& gl) {
    return make_cover_program(gl, with_depth_layers(depth_copy_fragment));
}
ShaderProgram make_layer_sum_program(const Gl& gl) {
    return make_cover_program(gl, with_depth_layers(layer_sum_fragment));
}
ShaderProgram make_layers_picture_program(const Gl& gl, bool per_sample) {
    return make_cover_program(gl, with_depth_layers(std::string(seen_from_glsl(per_sample)) + layers_picture_fragment));
}

} // namespace server::render
