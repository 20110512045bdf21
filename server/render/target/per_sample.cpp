#include "render/target/per_sample.hpp"

#include "render/target/sheet.hpp"

namespace server::render {
namespace {

// seen_from() for draw_per_sample(). Window depth is linear on a plane, so a large second difference of depths means an
// outline. Smaller differences also occur on a ball inside its outline. They are ignored: a piece of a volume that is
// thinner than 1 % of the depth range is not visible.
// A surface is steep at its outline, so its samples may lie far behind its depth in the middle of the pixel. Therefore
// gl_FragDepth, which separates them from samples behind the surface, is close to the depth behind the outline.
constexpr const char* per_sample = R"(
uniform sampler2D opaque;
// 1: draws samples behind outlines, and all samples without an outline; 0: draws samples in front of outlines
uniform float behind;
const float least_bend = 1e-2;
const float least_turn = 0.5; // smallest second difference at an outline, divided by the larger first difference
const ivec2 around[8] = ivec2[](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1),
                                ivec2(-1, -1), ivec2(1, 1), ivec2(-1, 1), ivec2(1, -1));
vec2 seen_from() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = textureSize(opaque, 0) - 1;
    float own = texelFetch(opaque, pixel, 0).r, near = own, far = own, bend = 0.0;
    float z[8];
    for (int i = 0; i < 8; ++i) {
        z[i] = texelFetch(opaque, clamp(pixel + around[i], ivec2(0), last), 0).r;
        near = min(near, z[i]);
        far = max(far, z[i]);
    }
    for (int i = 0; i < 8; i += 2) {
        float turn = abs(z[i] + z[i + 1] - 2.0 * own);
        if (turn > least_turn * max(abs(z[i] - own), abs(z[i + 1] - own))) bend = max(bend, turn);
    }
    gl_FragDepth = 0.0;
    if (bend < least_bend) {
        if (behind < 0.5) discard;
        return gl_FragCoord.xy;
    }
    float middle = 0.5 * (near + far), last_near = near, first_far = far;
    ivec2 taken = ivec2(0);
    bool found = own > middle == behind > 0.5;
    for (int i = 0; i < 8; ++i) {
        if (z[i] > middle) first_far = min(first_far, z[i]); else last_near = max(last_near, z[i]);
        if (!found && z[i] > middle == behind > 0.5) {
            taken = around[i];
            found = true;
        }
    }
    if (own > middle) first_far = min(first_far, own); else last_near = max(last_near, own);
    gl_FragDepth = mix(last_near, first_far, first_far < 1.0 ? 0.8 : 0.9999);
    return clamp(gl_FragCoord.xy + vec2(taken), vec2(0.5), vec2(last) + 0.5);
}
)";

constexpr const char* per_pixel = "vec2 seen_from() { return gl_FragCoord.xy; }\n";

} // namespace

const char* seen_from_glsl(bool of_samples) { return of_samples ? per_sample : per_pixel; }

void draw_per_sample(const Gl& gl, const ShaderProgram& program, const PerSample& what,
                     const std::function<void()>& draw) {
    bind(gl, what.unit, what.opaque);
    program.set("opaque", what.unit);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_LEQUAL);
    program.set("behind", 1.0F);
    draw();
    gl.DepthFunc(GL_GREATER);
    program.set("behind", 0.0F);
    draw();
    gl.DepthFunc(GL_LEQUAL);
    gl.DepthMask(GL_TRUE);
}

} // namespace server::render
