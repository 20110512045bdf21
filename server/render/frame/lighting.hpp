// The lights of a frame; protocol/lighting.glsl says how they light a surface.
#pragma once

namespace ciel::render {

// Strengths; 0 is off.
struct Lighting {
    float ambient = 1;   // from everywhere
    float headlight = 1; // at the eye
    float key_light = 1; // over the viewer's left shoulder
};

// Darkens lit opaque surfaces where others block the ambient light (ambient_occlusion.hpp).
struct Occlusion {
    double radius = 0; // length within which surfaces shade each other; 0: none
    float strength = 1;
};

} // namespace ciel::render
