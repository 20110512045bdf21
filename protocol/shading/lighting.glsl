// How surfaces and points are lit. For desktop GLSL 3.30 and GLSL ES 3.00: the server and the page are both built from
// this text.

uniform vec3 lights; // strengths of the ambient light, the headlight and the key light

// Returns the normal on the side that is seen. `n`: the field's normal, of length 1, on the front side of the polygon.
// At the rim of a shape, the smooth normal can look away from the viewer where the flat polygon does not. Such a normal
// is mirrored. Negated, it would be lit from the other side, which gives dark slivers along a bright rim. A normal that
// looks far away from the viewer is negated, because then the winding of the polygon is wrong.
vec3 seen_normal(vec3 n, vec3 viewer) {
    if (!gl_FrontFacing) n = -n;
    float head = dot(n, viewer);
    if (head < -0.35) return -n;
    return n - 2.0 * min(head, 0.0) * viewer;
}

// Returns the normal of a surface on the viewer's side, of length 1. `place`: the fragment in eye space, in units of the
// scene's size: derivatives of small scenes must not underflow. `normal`: the field's, of any length; if it is 0, the
// normal of the polygon's plane is used.
vec3 facing_normal(vec3 place, vec3 normal, vec3 viewer) {
    vec3 plane = cross(dFdx(place), dFdy(place));
    float plane_length = length(plane);
    float normal_length = length(normal);
    if (normal_length > 1e-6) return seen_normal(normal / normal_length, viewer);
    if (plane_length <= 1e-30) return viewer; // a degenerate triangle has no plane; so it is not black
    return plane / (dot(plane, viewer) < 0.0 ? -plane_length : plane_length);
}

// `n`, on the viewer's side, and `viewer` have length 1. The highlight has exponent 40, computed by multiplications: in
// software, pow() would cost as much as the rest of the function.
vec3 lit_surface(vec3 base, vec3 n, vec3 viewer) {
    vec3 key = normalize(vec3(-0.45, 0.65, 0.6)); // over the viewer's left shoulder
    float head = dot(n, viewer);
    float to_key = dot(n, key);
    float wrapped = 0.5 + 0.5 * to_key;
    float halfway = max((head + to_key) * inversesqrt(2.0 + 2.0 * dot(key, viewer)), 0.0);
    float to_2 = halfway * halfway;
    float to_4 = to_2 * to_2;
    float to_8 = to_4 * to_4;
    float to_16 = to_8 * to_8;
    float shine = to_16 * to_16 * to_8;
    return base * (0.30 * lights.x + 0.38 * lights.y * head + 0.40 * lights.z * wrapped * wrapped) +
           vec3(0.10 * lights.z * shine);
}

// Returns the color of a ball seen from the front. `side`: offset from the ball's middle, of length 1 at its rim.
vec3 lit_ball(vec3 base, vec2 side) {
    return base * (0.55 * lights.x + 0.45 * lights.y * sqrt(max(1.0 - dot(side, side), 0.0)));
}
