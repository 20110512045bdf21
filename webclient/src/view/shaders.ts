// Shaders of surfaces, lines and points. The server uses the same code for colors and lighting, so that pictures and
// polygons look the same. PEELED is defined for depth peeling (peeling_shaders.ts).
import COLOR_SCALE from "../../../protocol/shading/color_scale.glsl?raw";
import DEPTH_LAYERS from "../../../protocol/shading/depth_layers.glsl?raw";
import LIGHTING from "../../../protocol/shading/lighting.glsl?raw";
import { ENDS_PER_ROW, VERTICES_PER_LINE } from "./lines";
import { LAYERS, LINE_LAYERS } from "./peeling_shaders";

export const SURFACE_VERTEX = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float scalar;
uniform mat4 view;
uniform mat4 projection;
uniform float scale;
uniform float point_size;
uniform float value_origin; // subtracted from values, so that a small range far from 0 keeps its digits
out vec3 place; // position in units of the bounds' radius: derivatives of small scenes must not underflow
out vec3 eye_normal;
out float value;
out vec3 offset;
#ifdef POINTS
// Points at equal depth get small different depths, so that each of them becomes a layer of its own.
float own_depth(int number) { return float((uint(number) * 2654435769u) >> 24) * 1e-8; }
#endif
void main() {
  offset = position;
  vec4 at = view * vec4(position, 1.0);
  place = at.xyz * scale;
  eye_normal = mat3(view) * normal;
  value = scalar - value_origin;
  gl_PointSize = point_size + 1.0; // +1: room for soft edges; only used for points
  gl_Position = projection * at;
#ifdef POINTS
  gl_Position.z -= 2.0 * gl_Position.w * own_depth(gl_VertexID);
#endif
}`;

const COLORED = `#version 300 es
precision highp float;
in float value;
in vec3 offset; // position relative to the batch's origin
uniform vec4 clip[6];
uniform int clip_planes;
uniform vec4 color;
uniform float scale_row; // row of the color scale; -1: a solid color
layout(location = 0) out vec4 result;

void leave_out_what_is_clipped() {
  for (int i = 0; i < clip_planes; ++i)
    if (dot(clip[i].xyz, offset) + clip[i].w < 0.0) discard;
}

${COLOR_SCALE}
${LAYERS}`;

const LIT = `
uniform bool lit;
${LIGHTING}`;

export const SURFACE_FRAGMENT = `${COLORED}${LIT}
in vec3 place;
in vec3 eye_normal;
uniform bool has_normals;
uniform bool parallel;

void main() {
#ifdef PEELED
  float depth = depth_under_lines();
#endif
  leave_out_what_is_clipped();
#ifdef PEELED
  leave_out_what_is_seen(depth);
#endif
  vec3 base = base_color(value, color.rgb, scale_row);
  if (lit) {
    vec3 viewer = parallel ? vec3(0.0, 0.0, 1.0) : normalize(-place);
    base = lit_surface(base, facing_normal(place, has_normals ? eye_normal : vec3(0.0), viewer), viewer);
  }
  result = vec4(base, color.a);
}`;

// Draws a point as a disc with soft edges, shaded as a ball.
export const POINT_FRAGMENT = `${COLORED}${LIT}
uniform float point_size;
void main() {
  leave_out_what_is_clipped();
  vec2 from_center = (gl_PointCoord - 0.5) * (point_size + 1.0);
  float inside = point_size * 0.5 - length(from_center);
#ifdef PEELED
  float cover = color.a < 1.0 ? clamp(inside + 0.5, 0.0, 1.0) : step(0.0, inside); // a soft rim would be a layer
#else
  float cover = clamp(inside + 0.5, 0.0, 1.0);
#endif
  if (cover < 0.02) discard;
#ifdef PEELED
  leave_out_what_is_seen(depth_in_order());
  if (hides_all(color.a * cover)) record.x = -1.0;
#endif
  vec3 base = base_color(value, color.rgb, scale_row);
  if (lit) base = lit_ball(base, from_center / (point_size * 0.5 + 0.5));
  result = vec4(base, color.a * cover);
}`;

// Draws a line as a rectangle with soft edges. Clips the line at the near plane, because an end behind the camera has
// no position in the picture.
export const LINE_VERTEX = `#version 300 es
uniform highp sampler2D ends; // x, y, z, value (lines.ts)
uniform float value_origin;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 viewport;
uniform float half_width;
out float value;
out vec3 offset;
out float across;
out float weight;
flat out float joint; // depth change within half a line width: overlapping segments differ by at most this
${DEPTH_LAYERS}
vec4 end_at(int number) { return texelFetch(ends, ivec2(number % ${ENDS_PER_ROW}, number / ${ENDS_PER_ROW}), 0); }
void main() {
  int line = gl_VertexID / ${VERTICES_PER_LINE};
  int corner = gl_VertexID % ${VERTICES_PER_LINE}; // corners 0 1 2, 3 2 1 of two triangles
  if (corner > 3) corner = ${VERTICES_PER_LINE} - corner;
  vec4 from = end_at(2 * line);
  vec4 to = end_at(2 * line + 1);
  vec4 a = projection * (view * vec4(from.xyz, 1.0));
  vec4 b = projection * (view * vec4(to.xyz, 1.0));
  float in_a = a.z + a.w;
  float in_b = b.z + b.w;
  float start = in_a < 0.0 && in_b > 0.0 ? in_a / (in_a - in_b) : 0.0;
  float end = in_b < 0.0 && in_a > 0.0 ? in_a / (in_a - in_b) : 1.0;
  vec4 first = mix(a, b, start);
  vec4 last = mix(a, b, end);
  vec2 along = (last.xy / last.w - first.xy / first.w) * viewport * 0.5;
  float pixels = length(along);
  joint = joint_of_segment(first.z / first.w, last.z / last.w, half_width, pixels);
  along = pixels > 1e-6 ? along / pixels : vec2(1.0, 0.0);
  bool at_end = (corner & 1) == 1;
  float side = (corner & 2) == 2 ? 1.0 : -1.0;
  float t = at_end ? end : start;
  across = side * (half_width + 0.5);
  vec2 moved = vec2(-along.y, along.x) * across + along * half_width * (at_end ? 0.5 : -0.5);
  offset = mix(from.xyz, to.xyz, t);
  vec4 here = at_end ? last : first;
  value = mix(from.w - value_origin, to.w - value_origin, t);
  across *= here.w; // undoes perspective interpolation: linear in the picture
  weight = here.w;
  gl_Position = here + vec4(moved / viewport * 2.0 * here.w, 0.0, 0.0);
}`;

export const LINE_FRAGMENT = `${COLORED}
in float across;
in float weight;
uniform float half_width;
${LINE_LAYERS}
void main() {
  leave_out_what_is_clipped();
  float cover = clamp(half_width + 0.5 - abs(across / weight), 0.0, 1.0);
  if (cover < 0.02) discard; // invisible fragments would still write depth
  float alpha = color.a * cover;
#ifdef PEELED
  leave_out_the_same_line(depth_in_order(), alpha);
#endif
  result = vec4(base_color(value, color.rgb, scale_row), alpha);
}`;

export const BACKGROUND_VERTEX = `#version 300 es
out float height;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
  height = corner.y * 0.5 + 0.5;
  gl_Position = vec4(corner, 1.0, 1.0);
}`;

export const BACKGROUND_FRAGMENT = `#version 300 es
precision highp float;
in float height;
uniform vec3 top;
uniform vec3 bottom;
out vec4 result;
void main() {
  result = vec4(mix(bottom, top, height), 1.0);
}`;
