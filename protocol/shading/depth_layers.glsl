// Depth peeling of transparent layers, shared by the server and the page: rounding, the start of a layer, and the joints
// of lines. For desktop GLSL 3.30 and GLSL ES 3.00; both are built from this text.
// After Everitt, "Interactive order-independent transparency", NVIDIA 2001.

const float least = 5e-7; // smallest difference in depth that counts: a few steps of 24 bits, plus rounding

// Returns the window depth with which a layer starts. `opaque`: depth of the opaque surfaces. `through`: transmittance
// of the nearer layers. The margin keeps a layer that coincides with an opaque surface in front of it. Where less
// than half a step of an 8-bit color comes through, it returns 0, which rejects all fragments.
float start_of_layer(float opaque, float through) {
    return through < 1.0 / 512.0 ? 0.0 : min(opaque + 1e-6, 1.0);
}

// Segments of a transparent line overlap in joints, and each would absorb light there. So a layer records, at each
// pixel, the number of the line's mesh (x; 0: no transparent line) and the depth to which the line's joint reaches (y).
// Returns whether a fragment belongs to the recorded line. `joint`: depth that its own joint spans.
bool is_in_joint(vec2 record, float number, float depth, float joint) {
    return number > 0.5 && record.x == number && depth - joint < record.y;
}
