// The color of a value (protocol/colors.md). For desktop GLSL 3.30 and GLSL ES 3.00: the server and the page are both
// built from this text.

// One row per color scale. The first texels of a stepped scale are the colors of its steps.
uniform highp sampler2D scale_colors;
// One row per color scale, of five texels:
//   (low, 1 / width, steps, way),
//   (smallest, largest value inside the range),
//   the colors of values below the range, of values above it, and of missing values.
// way: 0: linear; 1: logarithmic; negative: logarithmic on both sides of zero, and nearly linear within -way of zero.
// If not linear, `low` and `width` are logarithms to base 2. The caller subtracts an origin from `low`, from the values
// inside, and from `value`: values of a small range far from 0 then keep their digits.
uniform highp sampler2D scale_rules;

// Missing values (NaN and infinite ones) are detected by their bits: compilers may assume that x != x never holds.
vec3 scale_color(float value, float row_of) {
    int row = int(row_of + 0.5);
    if ((floatBitsToUint(value) & 0x7fffffffu) >= 0x7f800000u) return texelFetch(scale_rules, ivec2(4, row), 0).rgb;
    vec4 inside = texelFetch(scale_rules, ivec2(1, row), 0);
    if (value < inside.x) return texelFetch(scale_rules, ivec2(2, row), 0).rgb;
    if (value > inside.y) return texelFetch(scale_rules, ivec2(3, row), 0).rgb;
    vec4 rule = texelFetch(scale_rules, ivec2(0, row), 0);
    float measure = rule.w > 0.5 ? log2(max(value, 1e-37)) : value;
    if (rule.w < 0.0) measure = sign(value) * log2(1.0 + abs(value) / -rule.w);
    float place = rule.y > 0.0 ? clamp((measure - rule.x) * rule.y, 0.0, 1.0) : 0.5;
    if (rule.z > 1.5) return texelFetch(scale_colors, ivec2(int(min(place * rule.z, rule.z - 0.5)), row), 0).rgb;
    vec2 size = vec2(textureSize(scale_colors, 0));
    return texture(scale_colors, vec2((place * (size.x - 1.0) + 0.5) / size.x, (float(row) + 0.5) / size.y)).rgb;
}

// Returns the solid color if `row` is negative.
vec3 base_color(float value, vec3 solid, float row) { return row < -0.5 ? solid : scale_color(value, row); }
