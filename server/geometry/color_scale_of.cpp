#include "geometry/color_scale_of.hpp"

#include "color/scale_range.hpp"

#include <nlohmann/json.hpp>

namespace server::geometry {
namespace {

color::RangeChoice choice_of(const scene::Coloring& coloring) {
    return {coloring.range, coloring.symmetric, coloring.log};
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
    scale.range = color::range_of(choice_of(coloring), data_range);
    scale.reverse = coloring.reverse;
    scale.log = coloring.log;
    scale.steps = static_cast<int>(coloring.steps.value_or(0));
    scale.nan = coloring.nan;
    scale.below = coloring.below;
    scale.above = coloring.above;
    return scale;
}

bool is_shown_by(const scene::Coloring& coloring, std::array<double, 2> data_range) {
    return color::is_shown_by(choice_of(coloring), data_range);
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

} // namespace server::geometry
