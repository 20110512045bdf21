// Where a scale is marked, and how its numbers are written; webclient/src/scene/ticks.ts is its twin, and both are held
// to tests/support/tick_cases.json.
#pragma once

#include <string>
#include <vector>

namespace ciel::annotations {

struct Tick {
    double value = 0;
    std::string label; // UTF-8; times 10^exponent of its scale
};

struct Scale {
    std::vector<Tick> ticks; // ascending
    int exponent = 0;        // written once beside the scale, not at every tick
};

// Multiples of 1, 2 or 5 times a power of ten between low and high, as many as possible but at most `most` of them.
// One tick where the range has no width, none where an end is not finite or low > high.
[[nodiscard]] Scale nice_scale(double low, double high, int most);
// The power of ten that is taken out of the numbers of a scale: 0 where they can be read as they are.
[[nodiscard]] int common_exponent(double low, double high);
// With the digits that tell apart thousandths of `span`; no trailing zeros, U+2212 as minus sign.
[[nodiscard]] std::string number_label(double value, double span, int exponent);
// As it stands, with so many digits at most and its own power of ten: a time, say, or a number on a logarithmic scale.
[[nodiscard]] std::string number_label(double value, int digits = 6);
// " ×10⁵", or nothing for 0
[[nodiscard]] std::string times_power_of_ten(int exponent);
// m^2/s^2 -> m²/s²: what importers write, as people write it.
[[nodiscard]] std::string pretty_units(const std::string& units);

} // namespace ciel::annotations
