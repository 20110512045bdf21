#include "render/peeling_shaders.hpp"

#include "render/per_sample.hpp"

namespace ciel::render {
namespace {

constexpr const char* depth_copy_fragment = R"(#version 330 core
uniform sampler2D opaque;
uniform vec2 viewport;
void main() { gl_FragDepth = texture(opaque, gl_FragCoord.xy / viewport).r; }
)";

constexpr const char* layer_sum_fragment = R"(#version 330 core
uniform sampler2D layer;
uniform sampler2D volumes;
uniform vec2 viewport;
out vec4 picture;
void main() {
    vec4 surface = texelFetch(layer, ivec2(gl_FragCoord.xy), 0);
    vec4 volume = texture(volumes, gl_FragCoord.xy / viewport);
    picture = vec4((volume.rgb + (1.0 - volume.a) * surface.rgb) * surface.a, surface.a);
}
)";

// Where there are two by two of the layers' pixels to one, the filter takes their mean.
constexpr const char* layers_picture_fragment = R"(
uniform sampler2D sum;
uniform sampler2D volumes;
uniform vec2 viewport;
out vec4 picture;
void main() {
    vec2 place = seen_from() / viewport;
    vec4 layers = texture(sum, place);
    vec4 volume = texture(volumes, place);
    picture = vec4(layers.rgb + layers.a * volume.rgb, layers.a * (1.0 - volume.a));
}
)";

} // namespace

ShaderProgram make_depth_copy_program(const Gl& gl) { return make_cover_program(gl, depth_copy_fragment); }
ShaderProgram make_layer_sum_program(const Gl& gl) { return make_cover_program(gl, layer_sum_fragment); }
ShaderProgram make_layers_picture_program(const Gl& gl, bool per_sample) {
    return make_cover_program(gl, std::string("#version 330 core\n") + seen_from_glsl(per_sample) +
                                      layers_picture_fragment);
}

} // namespace ciel::render
