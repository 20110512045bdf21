// Computes the marks and labels of a color bar. The web page runs the same code (server/page).
#pragma once

#include "color/color_scale.hpp"

namespace server::annotations {

struct ColorTick {
    double value = 0;
    double at = 0;     // position on the bar, from 0 at its lower end to 1
    std::string label; // UTF-8; empty: a mark without label
};

// Returns n if the numbers of a legend are divided by 10^n, and the title of the legend then contains this power.
// Returns 0 if the numbers are short without it, and for a logarithmic scale.
[[nodiscard]] int exponent_of(const color::ColorScale& scale);
// Returns `value` as text in the format of number_label() (ticks.hpp).
[[nodiscard]] std::string label_on(const color::ColorScale& scale, double value);
// Returns ticks in ascending order inside the scale's range. Returns a single tick if the range has no width.
// Linear scale: the ticks of nice_scale() (ticks.hpp), at most `most`.
// Logarithmic scale: labels at powers of ten, and marks at the other multiples. If there are fewer than 3 labels, the
// multiples 2 and 5 get labels, too. If there are still fewer than 3 labels, the ticks are as on a linear scale.
// Scale with steps: marks at the bounds of the steps, at most about `most_marks`. If there are many steps, only every
// n-th bound has a label.
[[nodiscard]] std::vector<ColorTick> color_ticks(const color::ColorScale& scale, int most = 6,
                                                 int most_marks = color::most_color_steps + 1);

} // namespace server::annotations
