// Where a legend has its marks and what stands beside them; webclient/src/scene/color_ticks.ts is its twin.
#pragma once

#include "color/color_scale.hpp"

namespace ciel::annotations {

struct ColorTick {
    double value = 0;
    double at = 0;     // along the bar, from 0 at its lower end to 1
    std::string label; // UTF-8; empty: a mark alone
};

// The power of ten that is taken out of the numbers of a scale and stands in its title; 0 on a logarithmic one.
[[nodiscard]] int exponent_of(const color::ColorScale& scale);
// A value as it stands beside the scale, by number_label of ticks.hpp.
[[nodiscard]] std::string label_on(const color::ColorScale& scale, double value);
// Linear: nice_scale of ticks.hpp, at most `most` of them. Logarithmic: powers of ten, with 2 and 5 of each, or
// nice_scale, where there are too few of them, and the multiples between as marks. Steps: their bounds; where there are
// many, every n-th has a label, and of more than `most_marks` only every m-th has a mark. In ascending order, inside
// the range; one for a range without width.
[[nodiscard]] std::vector<ColorTick> color_ticks(const color::ColorScale& scale, int most = 6,
                                                 int most_marks = color::most_color_steps + 1);

} // namespace ciel::annotations
