#include "color/color_map.hpp"

#include "ciel/types.hpp"
#include "color/color_tables.hpp"

#include <algorithm>
#include <charconv>

namespace server::color {
namespace {

ColorTable decoded(const NamedColors& named) {
    ColorTable table{};
    const char* at = named.colors.data();
    for (auto& color : table)
        for (auto& channel : color) {
            std::from_chars(at, at + 2, channel, 16);
            at += 2;
        }
    return table;
}

const std::vector<ColorTable>& all_tables() {
    static const std::vector<ColorTable> tables = [] {
        std::vector<ColorTable> out;
        for (const NamedColors& named : color_tables()) out.push_back(decoded(named));
        return out;
    }();
    return tables;
}

} // namespace

const std::vector<std::string>& color_map_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out;
        for (const NamedColors& named : color_tables()) out.emplace_back(named.name);
        return out;
    }();
    return names;
}

std::size_t color_map_index(const std::string& name) {
    const auto& names = color_map_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    std::string known;
    for (const std::string& other : names) known += (known.empty() ? "" : ", ") + other;
    ciel::fail("there is no color map '" + name + "'; there are " + known);
}

const ColorTable& color_map(const std::string& name) { return all_tables()[color_map_index(name)]; }

} // namespace server::color
