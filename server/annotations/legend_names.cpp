#include "annotations/legend_names.hpp"

#include "annotations/color_ticks.hpp"
#include "annotations/ticks.hpp"

#include <algorithm>
#include <map>

namespace server::annotations {
namespace {

constexpr std::size_t most_listed = 2;

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < std::min(words.size(), most_listed); ++i) text += (i == 0 ? "" : ", ") + words[i];
    if (words.size() > most_listed) text += " and " + std::to_string(words.size() - most_listed) + " more";
    return text;
}

std::string name_of_slice(const NamedLayer& slice) {
    const auto& [x, y, z] = slice.normal;
    const std::string start = slice.contours ? "Lines on " : "";
    if ((x != 0) + (y != 0) + (z != 0) != 1) return start + (slice.contours ? "free plane" : "Free plane");
    const std::size_t axis = x != 0 ? 0 : y != 0 ? 1 : 2;
    return start + (slice.contours ? "slice at " : "Slice at ") + "xyz"[axis] + " = " +
           number_label(slice.origin[axis]);
}

std::vector<std::string> each_once(const std::vector<std::string>& names) {
    std::vector<std::string> out;
    for (const std::string& name : names)
        if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
    return out;
}

} // namespace

std::string legend_name_of(const NamedLayer& layer) {
    if (layer.type == "iso") return "Iso-surface of " + layer.array;
    if (layer.type == "slice") return name_of_slice(layer);
    if (layer.type == "surface") return layer.groups.empty() ? "Boundary" : "Boundary: " + listed(layer.groups);
    if (layer.type == "edges") return "Edges";
    if (layer.type == "points") return "Points";
    if (layer.type == "volume") return "Volume";
    return {};
}

std::vector<std::string> legend_names(const std::vector<NamedLegend>& legends) {
    std::vector<std::string> told;
    std::map<std::pair<std::string, std::string>, int> taken;
    for (const NamedLegend& legend : legends) {
        const auto is_of_array = [&](const NamedLegend& other) { return other.array == legend.array; };
        if (std::count_if(legends.begin(), legends.end(), is_of_array) < 2) {
            told.emplace_back();
            continue;
        }
        std::string name = listed(each_once(legend.names));
        if (const int count = ++taken[{legend.array, name}]; count > 1) name += " (" + std::to_string(count) + ")";
        told.push_back(std::move(name));
    }
    return told;
}

std::string legend_title(const std::string& array, const std::string& units, const color::ColorScale& scale) {
    const std::string pretty = pretty_units(units);
    return array + (pretty.empty() ? "" : " [" + pretty + "]") + times_power_of_ten(exponent_of(scale));
}

} // namespace server::annotations
