#include "color/color_scale.hpp"

#include "color/color_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace server::color {
namespace {

using Rgb = std::array<double, 3>; // sRGB channels from 0 to 255

// Largest tolerance for the rounding of floats in limits_of(), as a share of the width of the range. If a range would
// need a larger tolerance for floats, its values are assumed to be doubles.
constexpr double largest_slack = 1e-3;

// The value of log(1 + |v| / w) at the ends of a logarithmic range from -r to r (protocol/colors.md).
const double log_of_reach = std::log1p(1 / linear_share);

Rgb between(const Rgb8& a, const Rgb8& b, double share) {
    Rgb color{};
    for (std::size_t k = 0; k < 3; ++k) color[k] = a[k] + share * (static_cast<double>(b[k]) - a[k]);
    return color;
}

Rgb of_table(const ColorTable& table, double at) {
    const double index = std::clamp(at, 0.0, 1.0) * static_cast<double>(table.size() - 1);
    const auto first = static_cast<std::size_t>(index);
    return between(table[first], table[std::min(first + 1, table.size() - 1)], index - static_cast<double>(first));
}

Rgb of_points(const std::vector<ColorPoint>& points, double at) {
    const auto next = std::find_if(points.begin(), points.end(), [&](const ColorPoint& p) { return p.at > at; });
    if (next == points.begin()) return between(points.front().color, points.front().color, 0);
    const ColorPoint& last = *std::prev(next);
    if (next == points.end()) return between(last.color, last.color, 0);
    return between(last.color, next->color, (at - last.at) / (next->at - last.at));
}

Rgb8 smooth_color(const ColorScale& scale, double place) {
    const double at = scale.reverse ? 1 - place : place;
    const Rgb color = scale.points.empty() ? of_table(color_map(scale.map), at) : of_points(scale.points, at);
    Rgb8 rounded{};
    for (std::size_t k = 0; k < 3; ++k) rounded[k] = static_cast<std::uint8_t>(std::lround(color[k]));
    return rounded;
}

Rgb8 inner_color(const ColorScale& scale, double place) {
    if (scale.steps < 2) return smooth_color(scale, place);
    const double step = std::clamp(std::floor(place * scale.steps), 0.0, scale.steps - 1.0);
    return smooth_color(scale, step / (scale.steps - 1.0));
}

} // namespace

std::vector<Rgb8> colors_along(const ColorScale& scale, int count) {
    std::vector<Rgb8> colors;
    colors.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) colors.push_back(inner_color(scale, count > 1 ? i / (count - 1.0) : 0.5));
    return colors;
}

std::vector<Rgb8> color_row(const ColorScale& scale, int smooth_count) {
    ColorScale smooth = scale;
    smooth.steps = 0;
    return colors_along(smooth, scale.steps > 1 ? scale.steps : smooth_count);
}

bool has_width(const ColorScale& scale) {
    const auto width = static_cast<float>(scale.range[1] - scale.range[0]);
    return std::isfinite(width) && width > 0;
}

double place_of(const ColorScale& scale, double value) {
    if (std::isnan(value)) return value;
    if (!has_width(scale)) return 0.5;
    const auto [low, high] = scale.range;
    if (!scale.log) return (value - low) / (high - low);
    if (is_log_of_both_signs(scale))
        return 0.5 + std::copysign(0.5 * std::log1p(std::abs(value) / (linear_share * high)), value) / log_of_reach;
    if (value <= 0) return -std::numeric_limits<double>::infinity();
    return std::log(value / low) / std::log(high / low);
}

double value_at(const ColorScale& scale, double place) {
    const auto [low, high] = scale.range;
    if (!has_width(scale)) return low;
    if (place == 1) return high; // exact, without rounding
    if (is_log_of_both_signs(scale)) {
        const double from_middle = 2 * place - 1;
        return std::copysign(linear_share * high * std::expm1(std::abs(from_middle) * log_of_reach), from_middle);
    }
    return scale.log ? low * std::pow(high / low, place) : low + place * (high - low);
}

ColorLimits limits_of(const ColorScale& scale) {
    if (!has_width(scale)) return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const auto [low, high] = scale.range;
    const double width = high - low;
    const double rounding = 2.5e-7 * std::max(std::abs(low), std::abs(high)); // two units in the last place of a float
    const double slack = 1e-6 * width + std::min(rounding, largest_slack * width);
    if (scale.log && low > 0) return {low * (1 - 1e-6), high * (1 + 1e-6)};
    return {low - slack, high + slack};
}

Rgb8 color_of(const ColorScale& scale, double value) {
    if (!std::isfinite(value)) return scale.nan;
    const ColorLimits inside = limits_of(scale);
    if (value < inside.low && scale.below) return *scale.below;
    if (value > inside.high && scale.above) return *scale.above;
    return inner_color(scale, std::clamp(place_of(scale, value), 0.0, 1.0));
}

} // namespace server::color
