// What tells apart two legends of one array: the layers that have their colors. webclient/src/scene/legend_names.ts is
// its twin, and both are held to tests/support/legend_cases.json.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace ciel::geometry {

// Short, for it stands over a color bar. `contours`: of the lines on the layer.
[[nodiscard]] std::string legend_name_of(const scene::Layer& layer, bool contours);

struct NamedLegend {
    std::string array;
    std::vector<std::string> names; // as legend_name_of has them
};

// Of each legend, empty where its array says it all.
[[nodiscard]] std::vector<std::string> legend_names(const std::vector<NamedLegend>& legends);

} // namespace ciel::geometry
