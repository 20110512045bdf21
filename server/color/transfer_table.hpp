// Color map and opacity points -> what a ray meets between two values of the property (pre-integration).
#pragma once

#include "color/color_scale.hpp"

namespace ciel::color {

// Mean color and extinction over a span of values, by the span's middle and width, both as shares of what the table is
// of. The middle of a column is a value, the middle of row r the width r / (rows - 1). The color is weighted by the
// extinction; within one slab light is not weakened on its way out of it, which is right to the first order of the
// slab's opacity.
struct TransferTable {
    static constexpr int columns = 1024, rows = 64;
    std::vector<float> texels; // RGB 0..1, then extinction per unit length; row by row
};

// The values that a table is of: those of the scale's range, and half as many more on a side beyond which values have a
// color of their own. Where they have not, what lies outside is all as at that end.
struct TableExtent {
    int halves_below = 0, halves_above = 0;
    [[nodiscard]] double width() const { return 1 + 0.5 * (halves_below + halves_above); }             // in ranges
    [[nodiscard]] double share_at(double place) const { return place * width() - 0.5 * halves_below; } // of the range
    [[nodiscard]] std::array<double, 2> values(const std::array<double, 2>& range) const;              // at its ends
    bool operator==(const TableExtent&) const = default;
};
[[nodiscard]] TableExtent table_extent(const ColorScale& scale);

// (place between the ends of the range, opacity of a ray that runs one unit length through it); by place.
using OpacityPoints = std::vector<std::array<double, 2>>;

// share: of the opacity of the points.
[[nodiscard]] TransferTable make_transfer_table(const ColorScale& scale, const OpacityPoints& opacity,
                                                double share = 1);

// -ln(1 - opacity): what a ray loses in a unit length, as an exponent. Opacity 1 is 0.999: it has to be finite.
[[nodiscard]] double extinction_of(double opacity);
// Straight between the points, constant outside.
[[nodiscard]] double opacity_at(const OpacityPoints& points, double place);

} // namespace ciel::color
