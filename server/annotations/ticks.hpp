// Computes the ticks of a scale, and formats its numbers. The web page runs the same code (server/page).
#pragma once

#include <string>
#include <vector>

namespace server::annotations {

struct Tick {
    double value = 0;
    std::string label; // UTF-8; shows value / 10^Scale::exponent
};

struct Scale {
    std::vector<Tick> ticks; // ascending
    // Exponent of the power of ten that is factored out of the labels and written once beside the scale.
    int exponent = 0;
};

// Returns at most `most` ticks, at multiples of 1, 2 or 5 times a power of ten. Returns a single tick for a range
// without width, and no tick if an end is not finite, low > high, or most < 1.
[[nodiscard]] Scale nice_scale(double low, double high, int most);
// Returns the exponent of the power of ten that is factored out of a scale's numbers; 0 if they are short without it.
[[nodiscard]] int common_exponent(double low, double high);
// Returns value / 10^exponent as text, with U+2212 as minus sign. The last digit is about a thousandth of `span`.
[[nodiscard]] std::string number_label(double value, double span, int exponent);
// Returns a text of at most `digits` digits, with its own power of ten if the value is very large or very small.
[[nodiscard]] std::string number_label(double value, int digits = 6);
// Returns the number of digits with which number_label() writes the two ends differently: 6, or up to 17 if needed.
[[nodiscard]] int digits_of_range(double low, double high);
[[nodiscard]] std::string times_power_of_ten(int exponent);
// Returns units with superscripts, for example "m²/s²" for "m^2/s^2". Importers write units in the second form.
[[nodiscard]] std::string pretty_units(const std::string& units);

} // namespace server::annotations
