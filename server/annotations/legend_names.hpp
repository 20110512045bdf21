// Makes the titles of legends, and names that distinguish several legends of one array. Each name lists the layers that
// use the colors of the legend. The web page runs the same code (server/page).
#pragma once

#include "ciel/types.hpp"
#include "color/color_scale.hpp"

#include <string>
#include <vector>

namespace server::annotations {

// The members of a scene's layer from which its name is made.
struct NamedLayer {
    std::string type;                  // as in the scene
    bool contours = false;             // the name is that of the contour lines on the layer
    std::string array{};               // of an iso-surface
    ciel::Vec3d origin{}, normal{};    // plane of a slice
    std::vector<std::string> groups{}; // patches of a boundary; empty: all
};

// Returns a short name that fits above a color bar. It is empty for layers that have no legend: outlines and clips.
[[nodiscard]] std::string legend_name_of(const NamedLayer& layer);

struct NamedLegend {
    std::string array;
    std::vector<std::string> names; // from legend_name_of
};

// Returns one name per legend. The name is empty if no other legend has the same array.
[[nodiscard]] std::vector<std::string> legend_names(const std::vector<NamedLegend>& legends);

// Returns the title as one line: name of the array, units in brackets, and the power of ten that is factored out of the
// scale's numbers.
[[nodiscard]] std::string legend_title(const std::string& array, const std::string& units,
                                       const color::ColorScale& scale);

} // namespace server::annotations
