// Marks and labels of a legend. The page runs this code, too (server/page).
#pragma once

#include "color/color_scale.hpp"

namespace ciel::annotations {

struct ColorTick {
    double value = 0;
    double at = 0;     // position on the bar, from 0 at its lower end to 1
    std::string label; // UTF-8; empty: a mark without label
};

// Returns the power of ten that is factored out of a scale's numbers and written in its title; 0 on a logarithmic
// scale.
[[nodiscard]] int exponent_of(const color::ColorScale& scale);
// Returns the label of a value beside the scale, as number_label of ticks.hpp writes it.
[[nodiscard]] std::string label_on(const color::ColorScale& scale, double value);
// Returns ticks in ascending order inside the range; one tick for a range without width.
// Linear scale: nice_scale of ticks.hpp with at most `most` ticks.
// Logarithmic scale: labels at powers of ten, or at 1, 2 and 5 times them if there are fewer than 3 labels, and marks
// at the other multiples. If there are still fewer than 3 labels: as on a linear scale.
// Scale with steps: marks at the bounds of the steps, at most about `most_marks`. With many steps, every n-th bound has
// a label.
[[nodiscard]] std::vector<ColorTick> color_ticks(const color::ColorScale& scale, int most = 6,
                                                 int most_marks = color::most_color_steps + 1);

} // namespace ciel::annotations
