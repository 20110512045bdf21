// The server's shading (render/) in GLSL ES 3.00, so that both streams show the same picture.

export const SURFACE_VERTEX = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float scalar;
uniform mat4 view;
uniform mat4 projection;
uniform float scale;
out vec3 place; // in units of the bounds' radius: derivatives of small scenes must not underflow
out vec3 eye_normal;
out float value;
void main() {
  vec4 at = view * vec4(position, 1.0);
  place = at.xyz * scale;
  eye_normal = mat3(view) * normal;
  value = scalar;
  gl_Position = projection * at;
}`;

export const SURFACE_FRAGMENT = `#version 300 es
precision highp float;
in vec3 place;
in vec3 eye_normal;
in float value;
uniform sampler2D scale_colors;
uniform vec4 rule; // low, 1 / width, steps, logarithmic: low and width of logarithms to base 2 then
uniform vec2 inside;
uniform vec3 below;
uniform vec3 above;
uniform vec3 missing;
uniform vec4 color;
uniform bool mapped;
uniform bool lit;
uniform bool has_normals;
uniform bool parallel;
out vec4 result;

vec3 base_color() {
  if (!mapped) return color.rgb;
  if ((floatBitsToUint(value) & 0x7fffffffu) >= 0x7f800000u) return missing;
  if (value < inside.x) return below;
  if (value > inside.y) return above;
  float measure = rule.w > 0.5 ? log2(max(value, 1e-37)) : value;
  float at = rule.y > 0.0 ? clamp((measure - rule.x) * rule.y, 0.0, 1.0) : 0.5;
  if (rule.z > 1.5) return texelFetch(scale_colors, ivec2(int(min(at * rule.z, rule.z - 0.5)), 0), 0).rgb;
  float width = float(textureSize(scale_colors, 0).x);
  return texture(scale_colors, vec2((at * (width - 1.0) + 0.5) / width, 0.5)).rgb;
}

vec3 facing_normal(vec3 viewer) {
  vec3 plane = cross(dFdx(place), dFdy(place));
  float plane_length = length(plane);
  vec3 n = plane_length > 1e-30 ? plane / plane_length : viewer;
  float normal_length = has_normals ? length(eye_normal) : 0.0;
  if (normal_length > 1e-6) n = eye_normal / normal_length;
  return dot(n, viewer) < 0.0 ? -n : n;
}

void main() {
  vec3 base = base_color();
  if (lit) {
    vec3 viewer = parallel ? vec3(0.0, 0.0, 1.0) : normalize(-place);
    vec3 n = facing_normal(viewer);
    vec3 key = normalize(vec3(-0.45, 0.65, 0.6));
    float head = dot(n, viewer);
    float wrapped = 0.5 + 0.5 * dot(n, key);
    float shine = pow(max(dot(n, normalize(key + viewer)), 0.0), 40.0);
    base = base * (0.30 + 0.38 * head + 0.40 * wrapped * wrapped) + vec3(0.10 * shine);
  }
  result = vec4(base, color.a);
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
