// Marks and labels of a legend; webclient/src/model/color_ticks.ts is its twin.
#pragma once

#include "color/color_scale.hpp"

namespace ciel::annotations {

struct ColorTick {
    double value = 0;
    double at = 0;     // position on the bar, from 0 at its lower end to 1
    std::string label; // UTF-8; empty: a mark without label
};

// The power of ten that is factored out of a scale's numbers and written in its title; 0 on a logarithmic scale.
[[nodiscard]] int exponent_of(const color::ColorScale& scale);
// The label of a value beside the scale, by number_label of ticks.hpp.
[[nodiscard]] std::string label_on(const color::ColorScale& scale, double value);
// Returns ticks in ascending order inside the range; one tick for a range without width.
// Linear: nice_scale of ticks.hpp with at most `most` ticks.
// Logarithmic: labels at powers of ten, or at 1, 2 and 5 times them when there are fewer than 3 labels, and marks at
// the other multiples; nice_scale when that is still too few. Steps: their bounds, at most about `most_marks`; with
// many steps, every n-th bound has a label.
[[nodiscard]] std::vector<ColorTick> color_ticks(const color::ColorScale& scale, int most = 6,
                                                 int most_marks = color::most_color_steps + 1);

} // namespace ciel::annotations
