// Computes the range of a color scale from a scene's coloring and the range of the data. The web page runs the same
// code (server/page).
#pragma once

#include <array>
#include <optional>

namespace server::color {

// The members of a scene's coloring that decide the range.
struct RangeChoice {
    std::optional<std::array<double, 2>> given; // used instead of the range of the data
    bool symmetric = false, log = false;
};

// Returns a range that is valid as ColorScale::range, and by whose width a graphics card can divide. `data`: range of
// the array at the shown time step.
[[nodiscard]] std::array<double, 2> range_of(const RangeChoice& choice, std::array<double, 2> data);
// Returns the part of a range that a logarithmic scale covers. If the range reaches zero, this part begins at a
// millionth of the upper end. If no value is above zero, returns some valid range.
[[nodiscard]] std::array<double, 2> range_above_zero(std::array<double, 2> range);
// Returns whether the scale can show the data. A logarithmic scale cannot if it takes its range from data without a
// value above zero.
[[nodiscard]] bool is_shown_by(const RangeChoice& choice, std::array<double, 2> data);

} // namespace server::color
