// Shader code of depth peeling. The shaders write the depth that they compare, because the fixed-function depth may
// differ in the last bit.

import DEPTH_LAYERS from "../../../protocol/shading/depth_layers.glsl?raw";

const VERSION = "#version 300 es\n";

export const defining = (source: string, ...names: string[]): string =>
  source.replace(VERSION, VERSION + names.map((name) => `#define ${name}\n`).join(""));

export const LAYERS = `
#ifdef PEELED
${DEPTH_LAYERS}
uniform highp sampler2D nearer;       // depths of the previous layer
uniform highp sampler2D nearer_lines; // line record of the previous layer
uniform float place_in_order;         // order of the batch among coincident batches (same_places.ts)
uniform float reach;                  // pixels by which lines and points extend beyond their position
layout(location = 1) out vec2 record; // x: number of the last line; y: depth up to which fragments belong to it
float depth_in_order() { return gl_FragCoord.z - place_in_order * least; }
// Depth of a surface, moved back so that it does not cover half the width of each line on it. The distance grows with
// the slope. Geometry close behind a steep surface may therefore come before the surface.
float depth_under_lines() {
  return depth_in_order() + reach * max(abs(dFdx(gl_FragCoord.z)), abs(dFdy(gl_FragCoord.z)));
}
void leave_out_what_is_seen(float depth) {
  record = texelFetch(nearer_lines, ivec2(gl_FragCoord.xy), 0).rg;
  if (depth <= texelFetch(nearer, ivec2(gl_FragCoord.xy), 0).r) discard;
  gl_FragDepth = depth;
}
#endif
`;

// Joins the segments of transparent lines, which overlap: each segment would absorb light in the overlap. A layer has
// the fragment of the nearest segment. With JOINING defined, the shader draws all segments again and keeps the largest
// coverage.
export const LINE_LAYERS = `
#ifdef PEELED
flat in float joint;
#ifdef JOINING
uniform highp sampler2D own_lines; // line record of the layer that is being drawn
uniform highp sampler2D behind; // depths of opaque surfaces
#endif
void leave_out_the_same_line(float depth) {
  leave_out_what_is_seen(depth);
  float number = color.a < 1.0 ? place_in_order : 0.0;
  float within = 3.0 * (joint + least);
  if (is_in_joint(record, number, depth, within)) discard;
#ifdef JOINING
  vec2 own = texelFetch(own_lines, ivec2(gl_FragCoord.xy), 0).rg;
  if (!is_in_joint(own, number, depth, within) || depth > texelFetch(behind, ivec2(gl_FragCoord.xy), 0).r) discard;
#endif
  record = vec2(number, depth + within);
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
void main() {
  vec4 color = texelFetch(layer, ivec2(gl_FragCoord.xy), 0);
  result = vec4(color.rgb * color.a, color.a);
}`;

export const LAYERS_PICTURE_FRAGMENT = `#version 300 es
precision highp float;
uniform highp sampler2D sum;
uniform int pixels; // sheet pixels per picture pixel along a side
out vec4 result;
void main() {
  ivec2 corner = ivec2(gl_FragCoord.xy) * pixels;
  vec4 total = vec4(0.0);
  for (int i = 0; i < pixels * pixels; ++i) total += texelFetch(sum, corner + ivec2(i % pixels, i / pixels), 0);
  result = total / float(pixels * pixels);
}`;
