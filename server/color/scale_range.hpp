// The range of a color scale, from a scene's coloring and the range of the data. The web page runs the same code
// (server/page).
#pragma once

#include <array>
#include <optional>

namespace server::color {

// The members of a scene's coloring that decide the range.
struct RangeChoice {
    std::optional<std::array<double, 2>> given; // used instead of the range of the data
    bool symmetric = false, log = false;
};

// `data`: range of the array at the shown step. The result satisfies ColorScale::range, and a graphics card can divide
// by its width.
[[nodiscard]] std::array<double, 2> range_of(const RangeChoice& choice, std::array<double, 2> data);
// Returns the part of a range that a logarithmic scale covers: the part above zero or, if the range reaches zero, from
// a millionth of its upper end. Returns a valid range even if no part is above zero.
[[nodiscard]] std::array<double, 2> range_above_zero(std::array<double, 2> range);
// Returns false if a logarithmic scale takes its range from data without a value above zero.
[[nodiscard]] bool is_shown_by(const RangeChoice& choice, std::array<double, 2> data);

} // namespace server::color
