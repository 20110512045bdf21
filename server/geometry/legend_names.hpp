// Names that distinguish several legends of one array. Each name lists the layers that use the colors of the legend.
// webclient/src/model/legend_names.ts has the same rules. Both are tested with tests/support/legend_cases.json.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace ciel::geometry {

// Returns a short name that fits above a color bar. `contours`: the name of the contour lines on the layer.
[[nodiscard]] std::string legend_name_of(const scene::Layer& layer, bool contours);

struct NamedLegend {
    std::string array;
    std::vector<std::string> names; // from legend_name_of
};

// Returns one name per legend. The name is empty if no other legend has the same array.
[[nodiscard]] std::vector<std::string> legend_names(const std::vector<NamedLegend>& legends);

} // namespace ciel::geometry
