#include "render/surfaces/color_scales.hpp"

#include "color/color_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel::render {
namespace {

constexpr int row_size = 1024; // texels per color scale
constexpr int rule_size = 5;
static_assert(color::most_color_steps <= row_size);

GLuint make_texture(const Gl& gl, GLint filter) {
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

void append_colors(std::vector<std::uint8_t>& pixels, const color::ColorScale& scale) {
    auto colors = color::color_row(scale, row_size);
    // A scale with steps has fewer colors. The shader does not read the added texels.
    colors.resize(row_size, color::Rgb8{});
    for (const color::Rgb8& color : colors) pixels.insert(pixels.end(), {color[0], color[1], color[2], 255});
}

void append_color(std::vector<float>& rules, const color::Rgb8& color) {
    for (const float channel : color::floats_of(color)) rules.push_back(channel);
    rules.push_back(1);
}

// Upper limit of 1 / width. For a subnormal width, 1 / width is infinite, and 0 times infinity is NaN.
constexpr double largest_factor = 3e38;

float origin_of(const color::ColorScale& scale) {
    constexpr double farthest = 1e37; // for an origin beyond this number, value - origin may overflow a float
    return scale.log || std::abs(scale.range[0]) > farthest ? 0 : static_cast<float>(scale.range[0]);
}

float less(double limit, double origin) {
    constexpr double largest = std::numeric_limits<float>::max();
    if (!std::isfinite(limit)) return static_cast<float>(limit);
    return static_cast<float>(std::clamp(limit - origin, -largest, largest));
}

void append_rule(std::vector<float>& rules, const color::ColorScale& scale) {
    const color::ColorLimits inside = color::limits_of(scale);
    const double origin = origin_of(scale);
    double low = scale.range[0];
    double width = 0;
    double way = 0; // kind of the scale, as in color_scale.glsl; 0: linear
    if (color::is_log_of_both_signs(scale)) {
        low = -std::log2(1 + 1 / color::linear_share);
        width = color::has_width(scale) ? -2 * low : 0;
        way = -std::max(color::linear_share * scale.range[1], 1e-37);
    } else if (color::has_width(scale)) {
        if (scale.log) low = std::log2(low);
        width = (scale.log ? std::log2(scale.range[1]) : scale.range[1]) - low;
        way = scale.log ? 1 : 0;
    }
    const auto ends = color::color_row(scale, 2);
    rules.insert(rules.end(), {static_cast<float>(low - origin),
                               width > 0 ? static_cast<float>(std::min(1 / width, largest_factor)) : 0.0F,
                               static_cast<float>(scale.steps), static_cast<float>(way)});
    rules.insert(rules.end(), {less(inside.low, origin), less(inside.high, origin), 0, 0});
    append_color(rules, scale.below.value_or(ends.front()));
    append_color(rules, scale.above.value_or(ends.back()));
    append_color(rules, scale.nan);
}

} // namespace

ColorScales::ColorScales(const Gl& gl)
    : gl_(gl), colors_(make_texture(gl, GL_LINEAR)), rules_(make_texture(gl, GL_NEAREST)) {}

ScaleRow ColorScales::row_of(const color::ColorScale& scale) {
    const auto found = std::find(next_.begin(), next_.end(), scale);
    if (found != next_.end()) return {static_cast<float>(found - next_.begin()), origin_of(scale)};
    static_cast<void>(color::color_map_index(scale.map)); // throws for an unknown map before anything is drawn
    next_.push_back(scale);
    return {static_cast<float>(next_.size() - 1), origin_of(scale)};
}

void ColorScales::upload() {
    if (next_.empty() || next_ == uploaded_) return;
    std::vector<std::uint8_t> pixels;
    std::vector<float> rules;
    for (const color::ColorScale& scale : next_) {
        append_colors(pixels, scale);
        append_rule(rules, scale);
    }
    const auto rows = static_cast<GLsizei>(next_.size());
    gl_.BindTexture(GL_TEXTURE_2D, colors_);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, row_size, rows, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    gl_.BindTexture(GL_TEXTURE_2D, rules_);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, rule_size, rows, 0, GL_RGBA, GL_FLOAT, rules.data());
    uploaded_ = next_;
}

void ColorScales::bind() const {
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_2D, rules_);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, colors_);
}

} // namespace ciel::render
