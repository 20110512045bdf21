// The server's shading in GLSL ES 3.00: a head light, both sides lit, the scalar looked up per fragment.

export const SURFACE_VERTEX = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float scalar;
uniform mat4 view;
uniform mat4 projection;
out vec3 eye;
out vec3 eye_normal;
out float value;
void main() {
  vec4 at = view * vec4(position, 1.0);
  eye = at.xyz;
  eye_normal = mat3(view) * normal;
  value = scalar;
  gl_Position = projection * at;
}`;

export const SURFACE_FRAGMENT = `#version 300 es
precision highp float;
in vec3 eye;
in vec3 eye_normal;
in float value;
uniform sampler2D map;
uniform vec2 range;
uniform vec4 color;
uniform vec3 missing;
uniform bool mapped;
uniform bool lit;
uniform bool has_normals;
uniform bool parallel;
out vec4 result;
void main() {
  vec3 base = color.rgb;
  if (mapped) {
    float span = range.y - range.x;
    float at = span > 0.0 ? clamp((value - range.x) / span, 0.0, 1.0) : 0.5;
    base = isnan(value) || isinf(value) ? missing : texture(map, vec2((at * 255.0 + 0.5) / 256.0, 0.5)).rgb;
  }
  if (lit) {
    vec3 facet = cross(dFdx(eye), dFdy(eye));
    vec3 n = normalize(has_normals && dot(eye_normal, eye_normal) > 0.0 ? eye_normal : facet);
    vec3 to_eye = parallel ? vec3(0.0, 0.0, 1.0) : normalize(-eye);
    float facing = abs(dot(n, to_eye));
    base = base * (0.25 + 0.75 * facing) + 0.12 * pow(facing, 32.0);
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
