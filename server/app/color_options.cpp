#include "app/color_options.hpp"

#include "app/commands.hpp"
#include "app/scene_options.hpp"
#include "color/color_map.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace server::app {
namespace {

constexpr const char* points_form = "AT=#rrggbb,AT=#rrggbb[,...]";

std::vector<double> parse_range(const std::string& text) {
    auto range = parse_numbers("--range", text);
    if (range.size() != 2) throw UsageError("--range " + text + " is not of the form MIN,MAX");
    return range;
}

// Checks only the form; parse_scene() checks colors and positions.
nlohmann::json parse_points(const std::string& text) {
    nlohmann::json points = nlohmann::json::array();
    for (const std::string& point : CLI::detail::split(text, ',')) {
        const auto equals = point.find('=');
        const auto at = parse_numbers("--color-points", point.substr(0, equals));
        if (equals == std::string::npos || at.size() != 1)
            throw UsageError("--color-points " + text + " is not of the form " + points_form);
        points.push_back({{"at", at[0]}, {"color", point.substr(equals + 1)}});
    }
    return points;
}

std::string map_names() {
    std::string names;
    for (const std::string& name : color::color_map_names()) names += (names.empty() ? "" : ", ") + name;
    return names;
}

} // namespace

void check_map(const std::string& option, const std::string& name) {
    const auto& known = color::color_map_names();
    if (std::find(known.begin(), known.end(), name) == known.end())
        throw UsageError(option + " " + name + " is not a color map; choose one of " + map_names());
}

void ColorOptions::add_to(CLI::App& command) {
    command
        .add_option(
            "--color", array,
            "Array that colors the layers: a point array (NAME), cell array (cell:NAME) or patch array (patch:NAME).")
        ->type_name("ARRAY");
    command.add_option("--map", map, "Color map: " + map_names() + ".")->type_name("NAME")->default_str("viridis");
    command
        .add_option("--color-points", points, "Custom colors instead of a map, at positions from 0 to 1 of the range.")
        ->type_name(points_form);
    command.add_option("--range", range, "Values at the two ends of the map; by default the range of the array.")
        ->type_name("MIN,MAX");
    command.add_flag("--reverse", reverse, "Reverse the color map.");
    command.add_flag("--log", log, "Logarithmic scale.");
    command.add_flag("--symmetric", symmetric, "Make the range symmetric about zero.");
    command.add_option("--steps", steps, "Number of discrete colors instead of a smooth map.")->type_name("N");
    command.add_option("--nan-color", nan, "Color of missing values.")
        ->type_name("#rrggbb")
        ->default_str("\"#808080\"");
    command
        .add_option("--below-color", below, "Color of values below the range; by default the lowest color of the map.")
        ->type_name("#rrggbb");
    command
        .add_option("--above-color", above, "Color of values above the range; by default the highest color of the map.")
        ->type_name("#rrggbb");
}

bool ColorOptions::any() const {
    return array || map || points || range || nan || below || above || steps || reverse || log || symmetric;
}

void ColorOptions::apply_to(nlohmann::json& color) const {
    const auto set = [&](const char* name, const auto& option) {
        if (option) color[name] = *option;
    };
    if (map) check_map("--map", *map);
    set("array", array);
    set("map", map);
    set("nan", nan);
    set("below", below);
    set("above", above);
    set("steps", steps);
    if (range) color["range"] = parse_range(*range);
    if (points) color["points"] = parse_points(*points);
    if (reverse) color["reverse"] = true;
    if (log) color["log"] = true;
    if (symmetric) color["symmetric"] = true;
}

} // namespace server::app
