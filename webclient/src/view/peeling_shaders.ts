// Shader code of depth peeling. The shaders write the depth that they compare, because the fixed-function depth may
// differ in the last bit.

import DEPTH_LAYERS from "../../../protocol/shading/depth_layers.glsl?raw";

const VERSION = "#version 300 es\n";

export const defining = (source: string, ...names: string[]): string =>
  source.replace(VERSION, VERSION + names.map((name) => `#define ${name}\n`).join(""));

export const LAYERS = `
#ifdef PEELED
#define RECORDED
${DEPTH_LAYERS}
uniform float place_in_order; // order of the batch among coincident batches (same_places.ts)
uniform float reach;          // pixels by which lines and points extend beyond their position
float depth_in_order() { return gl_FragCoord.z - place_in_order * least; }
// Depth of a surface, moved back so that it does not cover half the width of each line on it. The distance grows with
// the slope. Geometry close behind a steep surface may therefore come before the surface.
float depth_under_lines() {
  return depth_in_order() + reach * max(abs(dFdx(gl_FragCoord.z)), abs(dFdy(gl_FragCoord.z)));
}
void leave_out_what_is_seen(float depth) {
  if (!is_seen(depth)) discard;
  gl_FragDepth = depth;
}
#endif
`;

// With JOINING defined, this is the second pass over the lines (depth_layers.glsl).
export const LINE_LAYERS = `
#ifdef PEELED
flat in float joint;
#ifdef JOINING
uniform highp sampler2D behind; // depths of opaque surfaces
#endif
void leave_out_the_same_line(float depth, float alpha) {
  float number = color.a < 1.0 ? place_in_order : 0.0;
  float joint_reach = reach_of_joint(joint);
  if (!is_line_seen(number, depth, joint_reach)) discard;
#ifdef JOINING
  if (!is_of_own_line(number, depth, joint_reach, texelFetch(behind, ivec2(gl_FragCoord.xy), 0).r)) discard;
#endif
  record_line(number, alpha, depth, joint_reach);
  gl_FragDepth = depth;
}
#endif
`;

export const COVER_VERTEX = `#version 300 es
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }`;

export const DEPTH_COPY_FRAGMENT = `#version 300 es
precision highp float;
uniform highp sampler2D behind; // depths of opaque surfaces
uniform highp sampler2D sum;    // nearer layers; a: their transmittance
out vec4 result;
${DEPTH_LAYERS}
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  gl_FragDepth = start_of_layer(texelFetch(behind, pixel, 0).r, texelFetch(sum, pixel, 0).a);
  result = vec4(0.0);
}`;

export const LAYER_SUM_FRAGMENT = `#version 300 es
precision highp float;
uniform highp sampler2D layer;
out vec4 result;
${DEPTH_LAYERS}
void main() { result = light_of_layer(texelFetch(layer, ivec2(gl_FragCoord.xy), 0), vec4(0.0)); }`;

export const LAYERS_PICTURE_FRAGMENT = `#version 300 es
precision highp float;
uniform highp sampler2D sum;
uniform int pixels; // sheet pixels per picture pixel along a side
out vec4 result;
${DEPTH_LAYERS}
void main() {
  ivec2 corner = ivec2(gl_FragCoord.xy) * pixels;
  vec4 total = vec4(0.0);
  for (int i = 0; i < pixels * pixels; ++i) total += texelFetch(sum, corner + ivec2(i % pixels, i / pixels), 0);
  result = light_of_all(total / float(pixels * pixels), vec4(0.0));
}`;
