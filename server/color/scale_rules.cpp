#include "color/scale_rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace server::color {
namespace {

// Upper limit of 1 / width. For a subnormal width, 1 / width is infinite, and 0 times infinity is NaN.
constexpr double largest_factor = 3e38;
// Lower limit of the part around zero that is nearly linear; graphics cards may treat smaller floats as 0.
constexpr double least_linear = 1e-37;

struct Measured {
    double low = 0;
    double width = 0; // 0: the range has no width
    double way = 0;   // kind of the scale, as in color_scale.glsl
};

Measured measured(const ColorScale& scale) {
    const auto [low, high] = scale.range;
    if (!has_width(scale)) return {low, 0, 0};
    if (is_log_of_both_signs(scale)) {
        const double linear = std::max(linear_share * high, least_linear);
        const double reach = std::log2(1 + high / linear);
        return {-reach, 2 * reach, -linear};
    }
    if (scale.log) return {std::log2(low), std::log2(high) - std::log2(low), 1};
    return {low, high - low, 0};
}

float within_floats(double value) {
    constexpr double largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -largest, largest));
}

std::array<float, 4> opaque(const Rgb8& color) {
    const auto [red, green, blue] = floats_of(color);
    return {red, green, blue, 1};
}

} // namespace

float origin_of(const ColorScale& scale) {
    constexpr double farthest = 1e37; // for an origin beyond this number, value - origin may overflow a float
    return scale.log || std::abs(scale.range[0]) > farthest ? 0 : static_cast<float>(scale.range[0]);
}

ScaleRules scale_rules(const ColorScale& scale) {
    const double origin = origin_of(scale);
    const auto [low, width, way] = measured(scale);
    const double factor = width > 0 ? std::min(1 / width, largest_factor) : 0;
    const ColorLimits inside = limits_of(scale);
    const std::vector<Rgb8> ends = colors_along(scale, 2);
    ScaleRules rules;
    rules.origin = static_cast<float>(origin);
    rules.texels = {{{within_floats(low - origin), static_cast<float>(factor), static_cast<float>(scale.steps),
                      static_cast<float>(way)},
                     {within_floats(inside.low - origin), within_floats(inside.high - origin), 0, 0},
                     opaque(scale.below.value_or(ends.front())),
                     opaque(scale.above.value_or(ends.back())),
                     opaque(scale.nan)}};
    return rules;
}

} // namespace server::color
