#include "render/surfaces/color_scales.hpp"

#include "color/color_map.hpp"
#include "color/scale_rules.hpp"

#include <algorithm>
#include <tuple>

namespace server::render {
namespace {

constexpr int row_size = 1024; // texels per color scale
constexpr int rule_size = static_cast<int>(std::tuple_size_v<decltype(color::ScaleRules::texels)>);
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

void append_rules(std::vector<float>& texels, const color::ColorScale& scale) {
    for (const auto& texel : color::scale_rules(scale).texels) texels.insert(texels.end(), texel.begin(), texel.end());
}

} // namespace

ColorScales::ColorScales(const Gl& gl)
    : gl_(gl), colors_(make_texture(gl, GL_LINEAR)), rules_(make_texture(gl, GL_NEAREST)) {}

ScaleRow ColorScales::row_of(const color::ColorScale& scale) {
    const auto found = std::find(next_.begin(), next_.end(), scale);
    if (found != next_.end()) return {static_cast<float>(found - next_.begin()), color::origin_of(scale)};
    static_cast<void>(color::color_map_index(scale.map)); // throws for an unknown map before anything is drawn
    next_.push_back(scale);
    return {static_cast<float>(next_.size() - 1), color::origin_of(scale)};
}

void ColorScales::upload() {
    if (next_.empty() || next_ == uploaded_) return;
    std::vector<std::uint8_t> pixels;
    std::vector<float> rules;
    for (const color::ColorScale& scale : next_) {
        append_colors(pixels, scale);
        append_rules(rules, scale);
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

} // namespace server::render
