// TransferTable: pre-integrated color and extinction of a ray between two values.
#pragma once

#include "color/color_scale.hpp"

namespace server::color {

// Mean color and extinction over intervals of values. The texel in column c and row r is for one interval. The middle
// of the interval is (c + 0.5) / columns, and its width is r / (rows - 1), both as fractions of the table's extent. The
// color is weighted by the extinction. The attenuation of a ray within one interval is neglected. This is correct to
// first order in the opacity.
struct TransferTable {
    static constexpr int columns = 1024, rows = 64;
    std::vector<float> texels; // RGB 0..1, then extinction per unit length; row by row
};

// The interval of values that a TransferTable covers: the range of the scale, and half its width more at an end with a
// color `below` or `above`. Values outside look like values at the nearer end.
struct TableExtent {
    int halves_below = 0, halves_above = 0;
    // Returns the width of the table, as a multiple of the width of the range.
    [[nodiscard]] double width() const { return 1 + 0.5 * (halves_below + halves_above); }
    // Converts a position in the table (0 to 1) to a position in the range (0 at the lower end, 1 at the upper end).
    [[nodiscard]] double share_at(double place) const { return place * width() - 0.5 * halves_below; }
    // Returns the values at the two ends of the table. range: ColorScale::range of the scale.
    [[nodiscard]] std::array<double, 2> values(const std::array<double, 2>& range) const;
    bool operator==(const TableExtent&) const = default;
};
[[nodiscard]] TableExtent table_extent(const ColorScale& scale);

// Pairs (position in the range from 0 to 1, opacity of a unit length along a ray), sorted by position.
using OpacityPoints = std::vector<std::array<double, 2>>;

// share: factor by which all opacities are multiplied.
[[nodiscard]] TransferTable make_transfer_table(const ColorScale& scale, const OpacityPoints& opacity,
                                                double share = 1);

// Returns the optical depth of a unit length, -ln(1 - opacity). Opacity is clamped to 0.999 to keep the result finite.
[[nodiscard]] double extinction_of(double opacity);
// Returns the opacity at a position: linear between the points, constant outside them, 0 without points.
[[nodiscard]] double opacity_at(const OpacityPoints& points, double place);

} // namespace server::color
