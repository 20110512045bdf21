// Ticks of a scale and the format of its numbers. The page runs this code, too (server/page).
#pragma once

#include <string>
#include <vector>

namespace ciel::annotations {

struct Tick {
    double value = 0;
    std::string label; // UTF-8; the number is value / 10^exponent of the scale
};

struct Scale {
    std::vector<Tick> ticks; // ascending
    int exponent = 0;        // factored out of the labels; written once beside the scale
};

// Returns ticks at multiples of 1, 2 or 5 times a power of ten between low and high, as many as possible but at most
// `most`. Returns one tick for a range without width, none when an end is not finite or low > high.
[[nodiscard]] Scale nice_scale(double low, double high, int most);
// Returns the power of ten that is factored out of a scale's numbers; 0 when they are short enough without.
[[nodiscard]] int common_exponent(double low, double high);
// Returns value / 10^exponent as text, with digits down to about a thousandth of `span`, no trailing zeros, and U+2212
// as minus sign.
[[nodiscard]] std::string number_label(double value, double span, int exponent);
// Returns a single number as text, with at most `digits` digits and its own power of ten: for a time or a logarithmic
// tick.
[[nodiscard]] std::string number_label(double value, int digits = 6);
// Returns the number of digits with which number_label tells the ends of a range apart: 6, or one more than tells them
// apart, at most 17.
[[nodiscard]] int digits_of_range(double low, double high);
// Returns " ×10⁵" for 5, and an empty text for 0.
[[nodiscard]] std::string times_power_of_ten(int exponent);
// Returns units with superscripts: "m²/s²" for "m^2/s^2", as importers write it.
[[nodiscard]] std::string pretty_units(const std::string& units);

} // namespace ciel::annotations
