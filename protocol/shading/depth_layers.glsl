// Depth peeling of transparent layers, shared by the server and the page: which fragments a layer has, what it records of
// lines, and how layers are added up. For desktop GLSL 3.30 and GLSL ES 3.00; both are built from this text.
// After Everitt, "Interactive order-independent transparency", NVIDIA 2001.
// Macros: PEELED, for a fragment shader that draws a layer. RECORDED, with PEELED: the layer records lines. JOINING, with
// RECORDED: adds the test of the second pass over the lines.

const float least = 5e-7; // smallest difference in depth that counts: a few steps of 24 bits, plus rounding

// Returns the window depth with which a layer starts. `opaque`: depth of the opaque surfaces. `through`: transmittance
// of the nearer layers. The margin keeps a layer that coincides with an opaque surface in front of it. Where less
// than half a step of an 8-bit color comes through, it returns 0, which rejects all fragments.
float start_of_layer(float opaque, float through) {
    return through < 1.0 / 512.0 ? 0.0 : min(opaque + 1e-6, 1.0);
}

// Segments of a transparent line overlap in joints, and each would absorb light there. Therefore a layer records, at each
// pixel, the number of the line's mesh (x; 0: no transparent line, -1: nothing is visible behind) and the depth to which
// the line's joint reaches (y), and discards fragments of the same mesh up to that depth. A second pass draws the lines
// again and raises the layer's alpha to the largest of the segments.

// Returns the depth that the joints of a segment span. Its ends have the window depths from -1 to 1 and lie `pixels` apart.
float joint_of_segment(float first, float last, float half_width, float pixels) {
    return abs(last - first) * 0.5 * min(1.0, (half_width + 1.0) / max(pixels, 1e-6));
}

// Returns the depth within which fragments of a line belong together. `joint`: depth that its joints span.
float reach_of_joint(float joint) { return 3.0 * (joint + least); }

// Returns whether a fragment belongs to the recorded line.
bool is_in_joint(vec2 record, float number, float depth, float reach) {
    return number > 0.5 && record.x == number && depth - reach < record.y;
}

#ifdef PEELED
uniform highp sampler2D nearer; // window depths of the previous layer
#ifdef RECORDED
uniform highp sampler2D nearer_lines; // record of the previous layer
layout(location = 1) out highp vec2 record;
#endif

// Returns whether a fragment is behind the previous layer, and something is visible there. Sets `record` to that of the
// previous layer.
bool is_seen(float depth) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef RECORDED
    record = texelFetch(nearer_lines, pixel, 0).rg;
    if (record.x < 0.0) return false;
#endif
    return depth > texelFetch(nearer, pixel, 0).r;
}
#endif

#ifdef RECORDED
// Returns whether a fragment of a line is behind the previous layer, and not of a line that this layer has already drawn.
bool is_line_seen(float number, float depth, float reach) {
    return is_seen(depth) && !is_in_joint(record, number, depth, reach);
}

#ifdef JOINING
uniform highp sampler2D own_lines; // record of the layer that is being drawn
// Second pass. Returns whether a fragment belongs to the line of its pixel. `opaque`: depth of the opaque surfaces.
bool is_of_own_line(float number, float depth, float reach, float opaque) {
    return depth <= opaque && is_in_joint(texelFetch(own_lines, ivec2(gl_FragCoord.xy), 0).rg, number, depth, reach);
}
#endif

bool hides_all(float alpha) { return alpha > 0.998; }
// Call it after is_line_seen().
void record_line(float number, float alpha, float depth, float reach) {
    record = vec2(number > 0.5 ? number : hides_all(alpha) ? -1.0 : 0.0, depth + reach);
}
#endif

// Returns the light of a layer that is seen through `volume`, the premultiplied color of the volumes in front of it.
// Blending multiplies rgb by the transmittance of the nearer layers. Then it multiplies this transmittance by 1 - a.
vec4 light_of_layer(vec4 layer, vec4 volume) {
    return vec4((volume.rgb + (1.0 - volume.a) * layer.rgb) * layer.a, layer.a);
}

// Returns the light of all layers (a: their transmittance) and of `volume`, the volumes behind them.
vec4 light_of_all(vec4 layers, vec4 volume) {
    return vec4(layers.rgb + layers.a * volume.rgb, layers.a * (1.0 - volume.a));
}
