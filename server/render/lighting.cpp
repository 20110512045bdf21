#include "render/lighting.hpp"

namespace ciel::render {

const char* const lighting_glsl = R"(
uniform vec3 lights; // strengths of the ambient light, the headlight and the key light

vec3 lit_surface(vec3 base, vec3 n, vec3 viewer) {
    vec3 key = normalize(vec3(-0.45, 0.65, 0.6)); // over the viewer's left shoulder
    float head = dot(n, viewer);
    float wrapped = 0.5 + 0.5 * dot(n, key);
    float shine = pow(max(dot(n, normalize(key + viewer)), 0.0), 40.0);
    return base * (0.30 * lights.x + 0.38 * lights.y * head + 0.40 * lights.z * wrapped * wrapped) +
           vec3(0.10 * lights.z * shine);
}

// A ball seen from the front: `side` from its middle, of length 1 at its rim.
vec3 lit_ball(vec3 base, vec2 side) {
    return base * (0.55 * lights.x + 0.45 * lights.y * sqrt(max(1.0 - dot(side, side), 0.0)));
}
)";

} // namespace ciel::render
