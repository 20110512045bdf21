// The lights of a frame; protocol/lighting.glsl says how they light a surface.
#pragma once

namespace ciel::render {

// Strengths of the lights; 0 is off.
struct Lighting {
    float ambient = 1;   // light from all directions
    float headlight = 1; // light at the eye
    float key_light = 1; // light over the viewer's left shoulder
};

// Darkens lit opaque surfaces where nearby surfaces block the ambient light (ambient_occlusion.hpp).
struct Occlusion {
    double radius = 0; // largest distance at which surfaces shade each other, in world units; 0: off
    float strength = 1;
};

} // namespace ciel::render
