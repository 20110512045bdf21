// Names that distinguish several legends of one array: each names the layers that use its colors. Same rules as
// webclient/src/model/legend_names.ts; both are tested with tests/support/legend_cases.json.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace ciel::geometry {

// Returns a short name, to fit above a color bar. `contours`: for the contour lines on the layer.
[[nodiscard]] std::string legend_name_of(const scene::Layer& layer, bool contours);

struct NamedLegend {
    std::string array;
    std::vector<std::string> names; // from legend_name_of
};

// Returns one name per legend; empty if no other legend has the same array.
[[nodiscard]] std::vector<std::string> legend_names(const std::vector<NamedLegend>& legends);

} // namespace ciel::geometry
