#include "annotations/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace server::annotations {
namespace {

constexpr std::array superscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
constexpr int most_decimals = 15;
constexpr double smallest_span = 1e-300; // a smaller range gets only one tick, because more ticks would lose digits
// Range of exponents for which numbers are written without a power of ten. Coordinates of map grids, with seven digits
// before the decimal point, are in this range.
constexpr int smallest_plain = -3;
constexpr int largest_plain = 6;
// Ends of a scale are rounded to 6 digits: an end may be a float, and 1e-4 as a float is slightly less than 1e-4.
constexpr int digits_of_ends = 6;

int magnitude(double value) { return static_cast<int>(std::floor(std::log10(value))); }

// Returns the exponent of the rounded value: 9.9996 rounded to three digits is 10.0, so its exponent is 1.
int rounded_magnitude(double value, int digits) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*e", std::clamp(digits - 1, 0, most_decimals), value);
    return std::stoi(std::string(text.data()).substr(std::string(text.data()).find('e') + 1));
}

bool is_plain(int exponent) { return exponent >= smallest_plain && exponent <= largest_plain; }

int taken_out(double size, int digits) {
    const int exponent = is_plain(magnitude(size)) ? 0 : rounded_magnitude(size, digits);
    return is_plain(exponent) ? 0 : exponent;
}

std::string superscript(const std::string& digits) {
    std::string out;
    for (const char digit : digits) out += digit == '-' ? "⁻" : superscripts[static_cast<std::size_t>(digit - '0')];
    return out;
}

std::string power_of_ten(int exponent) { return "10" + superscript(std::to_string(exponent)); }

std::string with_decimals(double value, int decimals) {
    std::array<char, 400> text{}; // at most 309 digits before the decimal point
    std::snprintf(text.data(), text.size(), "%.*f", std::clamp(decimals, 0, most_decimals), value);
    std::string out(text.data());
    const bool is_zero = out.find_first_not_of("-0.") == std::string::npos;
    if (out.front() == '-') out.replace(0, 1, is_zero ? "" : "−");
    return out;
}

std::string without_trailing_zeros(std::string number) {
    if (number.find('.') == std::string::npos) return number;
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    return number;
}

struct Step {
    double size = 0;
    int power = 0; // size is 1, 2 or 5 times 10^power
};

struct Multiples {
    // The first and last multiple of a step in a range, divided by the step. These integers are stored as doubles,
    // because they may exceed the range of integer types.
    double first = 0, last = 0;
    [[nodiscard]] double count() const { return last - first + 1; }
};

Multiples multiples(double low, double high, double step) {
    const double slack = 1e-9 * (high - low) / step; // tolerance that includes multiples at the ends despite rounding
    return {std::ceil(low / step - slack), std::floor(high / step + slack)};
}

Step nice_step(double low, double high, int most) {
    for (int power = magnitude((high - low) / most);; ++power)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double size = digit * std::pow(10.0, power);
            if (multiples(low, high, size).count() <= most) return {size, power};
        }
}

} // namespace

int common_exponent(double low, double high) {
    const double largest = std::max(std::abs(low), std::abs(high));
    return largest > 0 && std::isfinite(largest) ? taken_out(largest, digits_of_ends) : 0;
}

std::string number_label(double value, double span, int exponent) {
    if (!std::isfinite(value)) return "n/a";
    const double size = span > 0 && std::isfinite(span) ? span : std::abs(value);
    if (!(size > 0)) return "0";
    return without_trailing_zeros(with_decimals(value * std::pow(10.0, -exponent), 2 - magnitude(size) + exponent));
}

std::string number_label(double value, int digits) {
    if (!std::isfinite(value)) return "n/a";
    const int exponent = value == 0 ? 0 : taken_out(std::abs(value), digits);
    const double mantissa = value * std::pow(10.0, -exponent);
    if (!std::isfinite(mantissa)) return "n/a";
    const int places = mantissa == 0 ? 0 : magnitude(std::abs(mantissa));
    const std::string text = without_trailing_zeros(with_decimals(mantissa, digits - 1 - places));
    return exponent != 0 && text == "1" ? power_of_ten(exponent) : text + times_power_of_ten(exponent);
}

int digits_of_range(double low, double high) {
    constexpr int usual = 6, most = 17;
    if (low == high) return usual;
    int digits = usual;
    while (digits < most && number_label(low, digits) == number_label(high, digits)) ++digits;
    return digits == usual ? usual : std::min(digits + 1, most);
}

std::string times_power_of_ten(int exponent) { return exponent == 0 ? "" : " ×" + power_of_ten(exponent); }

Scale nice_scale(double low, double high, int most) {
    Scale scale;
    if (!std::isfinite(low) || !std::isfinite(high) || low > high || most < 1) return scale;
    scale.exponent = common_exponent(low, high);
    const double span = high - low;
    const double rounding = std::max(1e-13 * std::max(std::abs(low), std::abs(high)), smallest_span);
    if (!(span > rounding) || !std::isfinite(span)) {
        scale.ticks.push_back({low, number_label(low, 0, scale.exponent)});
        return scale;
    }
    const Step step = nice_step(low, high, most);
    const Multiples found = multiples(low, high, step.size);
    const double unit = std::pow(10.0, -scale.exponent);
    const auto count = static_cast<int>(found.last - found.first);
    for (int i = 0; i <= count; ++i) {
        const double value = (found.first + i) * step.size;
        scale.ticks.push_back({value, with_decimals(value * unit, scale.exponent - step.power)});
    }
    return scale;
}

std::string pretty_units(const std::string& units) {
    std::string out;
    for (std::size_t i = 0; i < units.size(); ++i) {
        const std::size_t digits = i + 1 < units.size() && units[i + 1] == '-' ? i + 2 : i + 1;
        const std::size_t end = units.find_first_not_of("0123456789", digits);
        const std::size_t stop = end == std::string::npos ? units.size() : end;
        if (units[i] != '^' || digits >= units.size() || stop == digits) {
            out += units[i];
            continue;
        }
        out += superscript(units.substr(i + 1, stop - i - 1));
        i = stop - 1;
    }
    return out;
}

} // namespace server::annotations
