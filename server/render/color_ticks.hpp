// Where a legend has its marks and what stands beside them; webclient/src/scene/ticks.ts is its twin.
#pragma once

#include "render/color_scale.hpp"

namespace ciel::render {

struct ColorTick {
    double value = 0;
    double at = 0;     // along the bar, from 0 at its lower end to 1
    std::string label; // UTF-8; empty: a mark alone
};

// Linear: about `wanted` round values. Logarithmic: powers of ten, with 2 and 5 of each, or round values, where there
// are too few of them, and the multiples between as marks. Steps: their bounds; where there are many, every n-th has a
// label. In ascending order, inside the range; one for a range without width.
[[nodiscard]] std::vector<ColorTick> color_ticks(const ColorScale& scale, int wanted = 5);

// Enough digits to tell values apart that differ by a thousandth of `span`; of the value itself where `span` is not
// above zero. With U+2212 for the minus, exponents as 1.5e−7, and "n/a" for what is not finite.
[[nodiscard]] std::string value_label(double value, double span = 0);

} // namespace ciel::render
