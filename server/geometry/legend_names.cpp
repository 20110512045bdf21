#include "geometry/legend_names.hpp"

#include "annotations/ticks.hpp"
#include "scene/rules.hpp"

#include <algorithm>
#include <map>

namespace ciel::geometry {
namespace {

constexpr std::size_t most_listed = 2;

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < std::min(words.size(), most_listed); ++i) text += (i == 0 ? "" : ", ") + words[i];
    if (words.size() > most_listed) text += " and " + std::to_string(words.size() - most_listed) + " more";
    return text;
}

struct NameOf {
    bool contours = false;

    std::string operator()(const scene::IsoLayer& iso) const { return "Iso-surface of " + iso.array; }
    std::string operator()(const scene::SliceLayer& slice) const {
        const std::string start = contours ? "Lines on " : "";
        const auto [origin, normal] = plane_of(slice);
        if (std::count(normal.begin(), normal.end(), 0.0) != 2) return start + (contours ? "free plane" : "Free plane");
        const auto across = std::find_if(normal.begin(), normal.end(), [](double n) { return n != 0; });
        const auto axis = static_cast<std::size_t>(across - normal.begin());
        return start + (contours ? "slice at " : "Slice at ") + "xyz"[axis] + " = " +
               annotations::number_label(origin[axis]);
    }
    std::string operator()(const scene::SurfaceLayer& surface) const {
        return surface.groups.empty() ? "Boundary" : "Boundary: " + listed(surface.groups);
    }
    std::string operator()(const scene::EdgesLayer&) const { return "Edges"; }
    std::string operator()(const scene::PointsLayer&) const { return "Points"; }
    std::string operator()(const scene::VolumeLayer&) const { return "Volume"; }
    std::string operator()(const scene::OutlineLayer&) const { return {}; } // outlines and clips have no legend
    std::string operator()(const scene::ClipLayer&) const { return {}; }
};

std::vector<std::string> each_once(const std::vector<std::string>& names) {
    std::vector<std::string> out;
    for (const std::string& name : names)
        if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
    return out;
}

} // namespace

std::string legend_name_of(const scene::Layer& layer, bool contours) {
    return std::visit(NameOf{contours}, layer.kind);
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

} // namespace ciel::geometry
