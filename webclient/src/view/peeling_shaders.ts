// Shader parts for PEELED, and programs that cover a whole sheet (depth_peeling.ts). They write the depth that they
// compare: a fixed-function depth may differ in its last bit.

const VERSION = "#version 300 es\n";

/** Returns the source with the names defined. */
export const defining = (source: string, ...names: string[]): string =>
  source.replace(VERSION, VERSION + names.map((name) => `#define ${name}\n`).join(""));

export const LAYERS = `
#ifdef PEELED
uniform highp sampler2D nearer;       // depths of the layer before this one
uniform highp sampler2D nearer_lines; // its record
uniform float place_in_order;         // of what lies in the same place (same_places.ts)
uniform float reach;                  // of lines and points over the place where they are, in pixels
layout(location = 1) out vec2 record; // number of the last line, and how far back it is that
const float least = 5e-7;             // of 24 bits the last few, and what rounding takes
float depth_in_order() { return gl_FragCoord.z - place_in_order * least; }
// A little back, so that lines on it are not half buried. Where it is steep that is farther, and beside wide lines what
// lies just behind it comes before it.
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

// Segments overlap in their joints, where each would absorb light. Fragments of the same mesh as the last line, at the
// same depth within the depth change of a joint, belong to the same line. The nearest segment is in the layer. JOINING
// draws them again and keeps the largest coverage.
export const LINE_LAYERS = `
#ifdef PEELED
flat in float joint;
#ifdef JOINING
uniform highp sampler2D own_lines; // record of the layer itself
uniform highp sampler2D behind;    // depths of what is opaque
#endif
void leave_out_the_same_line(float depth) {
  leave_out_what_is_seen(depth);
  float number = color.a < 1.0 ? place_in_order : 0.0;
  float within = 3.0 * (joint + least);
  if (number > 0.5 && record.x == number && depth - within < record.y) discard;
#ifdef JOINING
  vec2 own = texelFetch(own_lines, ivec2(gl_FragCoord.xy), 0).rg;
  if (own.x != number || depth - within > own.y) discard;
  if (depth > texelFetch(behind, ivec2(gl_FragCoord.xy), 0).r) discard;
#endif
  record = vec2(number, depth + within);
}
#endif
`;

export const COVER_VERTEX = `#version 300 es
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }`;

// The offset draws layers coincident with opaque faces over them, despite rounding. Depth 0 ends a pixel whose nearer
// layers let less than half a color step through.
export const DEPTH_COPY_FRAGMENT = `#version 300 es
precision highp float;
uniform highp sampler2D behind;
uniform highp sampler2D sum;
out vec4 result;
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool is_done = texelFetch(sum, pixel, 0).a < 1.0 / 512.0;
  gl_FragDepth = is_done ? 0.0 : min(texelFetch(behind, pixel, 0).r + 1e-6, 1.0);
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
uniform int pixels; // of the sheet to one of the picture along a side
out vec4 result;
void main() {
  ivec2 corner = ivec2(gl_FragCoord.xy) * pixels;
  vec4 total = vec4(0.0);
  for (int i = 0; i < pixels * pixels; ++i) total += texelFetch(sum, corner + ivec2(i % pixels, i / pixels), 0);
  result = total / float(pixels * pixels);
}`;
