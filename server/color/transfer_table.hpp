// Color map and opacity points -> color and extinction along a ray between two values (pre-integration).
#pragma once

#include "color/color_scale.hpp"

namespace ciel::color {

// Mean color and extinction over an interval of values. A column's center is the interval's middle, row r has the width
// r / (rows - 1); both are fractions of the table's extent. The color is weighted by the extinction. Attenuation within
// a slab is neglected, which is correct to first order in the slab's opacity.
struct TransferTable {
    static constexpr int columns = 1024, rows = 64;
    std::vector<float> texels; // RGB 0..1, then extinction per unit length; row by row
};

// The values that a table covers: the scale's range, extended by half its width on each side with a color of its own
// (`below`, `above`). On a side without one, all values outside look like that end.
struct TableExtent {
    int halves_below = 0, halves_above = 0;
    [[nodiscard]] double width() const { return 1 + 0.5 * (halves_below + halves_above); }             // in ranges
    [[nodiscard]] double share_at(double place) const { return place * width() - 0.5 * halves_below; } // of the range
    [[nodiscard]] std::array<double, 2> values(const std::array<double, 2>& range) const; // at the table's ends
    bool operator==(const TableExtent&) const = default;
};
[[nodiscard]] TableExtent table_extent(const ColorScale& scale);

// (place between the ends of the range, opacity of one unit length along a ray); sorted by place.
using OpacityPoints = std::vector<std::array<double, 2>>;

// share: factor on the opacity of the points.
[[nodiscard]] TransferTable make_transfer_table(const ColorScale& scale, const OpacityPoints& opacity,
                                                double share = 1);

// Optical depth of a unit length: -ln(1 - opacity). Opacity is limited to 0.999 to keep it finite.
[[nodiscard]] double extinction_of(double opacity);
// Linear between the points, constant outside.
[[nodiscard]] double opacity_at(const OpacityPoints& points, double place);

} // namespace ciel::color
