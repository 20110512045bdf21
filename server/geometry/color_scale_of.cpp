#include "geometry/color_scale_of.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ciel::geometry {
namespace {

constexpr double largest_of_range = 4e37; // greatest end of a range; 1 / (twice this number) is not subnormal
constexpr double smallest_of_log = 1e-37; // least end of a log range; graphics cards may treat smaller floats as 0

// Limits an end of a range so that a graphics card can divide by the range's width.
double within_floats(double end) { return std::clamp(end, -largest_of_range, largest_of_range); }

std::array<double, 2> range_above_zero(std::array<double, 2> range) {
    auto [low, high] = range;
    if (!(high > 0)) return {1, 10}; // any valid range, because the scale shows no value (is_shown_by)
    if (!(low > 0)) low = high * std::pow(10, -log_decades);
    return {std::max(low, smallest_of_log), std::max(high, smallest_of_log)};
}

std::string hex_of(const color::Rgb8& color) {
    constexpr const char* digits = "0123456789abcdef";
    std::string text = "#";
    for (const unsigned channel : color) text.append({digits[channel >> 4U], digits[channel & 15U]});
    return text;
}

} // namespace

color::ColorScale color_scale_of(const scene::Coloring& coloring, std::array<double, 2> data_range) {
    color::ColorScale scale;
    scale.map = coloring.map;
    if (coloring.points)
        for (const scene::ColorPoint& point : *coloring.points) scale.points.push_back({point.at, point.color});
    if (coloring.range)
        scale.range = {within_floats((*coloring.range)[0]), within_floats((*coloring.range)[1])};
    else
        scale.range = {within_floats(data_range[0]), within_floats(data_range[1])};
    if (coloring.symmetric) {
        const double reach = std::max(std::abs(scale.range[0]), std::abs(scale.range[1]));
        scale.range = {-reach, reach};
    }
    if (coloring.log && !coloring.symmetric) scale.range = range_above_zero(scale.range);
    scale.reverse = coloring.reverse;
    scale.log = coloring.log;
    scale.steps = static_cast<int>(coloring.steps.value_or(0));
    scale.nan = coloring.nan;
    scale.below = coloring.below;
    scale.above = coloring.above;
    return scale;
}

bool is_shown_by(const scene::Coloring& coloring, std::array<double, 2> data_range) {
    return !coloring.log || coloring.symmetric || coloring.range || data_range[1] > 0;
}

nlohmann::json json_of(const color::ColorScale& scale) {
    nlohmann::json members = nlohmann::json::object();
    const color::ColorScale usual;
    if (scale.reverse) members["reverse"] = true;
    if (scale.log) members["log"] = true;
    if (scale.steps > 0) members["steps"] = scale.steps;
    if (scale.nan != usual.nan) members["nan"] = hex_of(scale.nan);
    if (scale.below) members["below"] = hex_of(*scale.below);
    if (scale.above) members["above"] = hex_of(*scale.above);
    for (const color::ColorPoint& point : scale.points)
        members["points"].push_back({{"at", point.at}, {"color", hex_of(point.color)}});
    return members;
}

} // namespace ciel::geometry
