// Ticks of a scale and the format of its numbers. webclient/src/model/ticks.ts is its twin; both are tested with
// tests/support/tick_cases.json.
#pragma once

#include <string>
#include <vector>

namespace ciel::annotations {

struct Tick {
    double value = 0;
    std::string label; // UTF-8; to be multiplied by 10^exponent of the scale
};

struct Scale {
    std::vector<Tick> ticks; // ascending
    int exponent = 0;        // written once beside the scale, not at every tick
};

// Multiples of 1, 2 or 5 times a power of ten between low and high, as many as possible but at most `most` of them.
// One tick for a range without width; none when an end is not finite or low > high.
[[nodiscard]] Scale nice_scale(double low, double high, int most);
// The power of ten that is factored out of a scale's numbers; 0 when they are short enough without.
[[nodiscard]] int common_exponent(double low, double high);
// value / 10^exponent, with digits down to about a thousandth of `span`; no trailing zeros, U+2212 as minus sign.
[[nodiscard]] std::string number_label(double value, double span, int exponent);
// A single number with at most `digits` digits and its own power of ten, such as a time or a logarithmic tick.
[[nodiscard]] std::string number_label(double value, int digits = 6);
// " ×10⁵", or nothing for 0
[[nodiscard]] std::string times_power_of_ten(int exponent);
// m^2/s^2 -> m²/s²: importers write the former.
[[nodiscard]] std::string pretty_units(const std::string& units);

} // namespace ciel::annotations
