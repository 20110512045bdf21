#include "render/color_ticks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ciel::render {
namespace {

constexpr int most_labels = 10; // of steps and decades: more would stand on each other
constexpr int most_marked_decades = 8;

double rounded(double value) { // to 12 digits: 0.1 + 0.2 is 0.3 on a legend
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", value);
    return std::strtod(text, nullptr);
}

std::vector<double> round_values(double low, double high, int wanted) {
    const double span = high - low;
    const double raw = span / std::max(1, wanted - 1);
    const double power = std::pow(10, std::floor(std::log10(raw)));
    double step = 10 * power;
    for (const double factor : {5.0, 2.5, 2.0, 1.0})
        if (factor * power >= raw * 0.99) step = factor * power;
    std::vector<double> values;
    for (auto k = static_cast<std::int64_t>(std::ceil(low / step - 1e-9));
         static_cast<double>(k) * step <= high + 1e-9 * span; ++k)
        values.push_back(rounded(static_cast<double>(k) * step));
    return values;
}

struct Marks {
    const ColorScale& scale;
    std::vector<ColorTick> ticks;

    void add(double value, bool has_label, double span) {
        const double at = std::clamp(place_of(scale, value), 0.0, 1.0);
        ticks.push_back({value, at, has_label ? value_label(value, span) : std::string()});
    }
};

void add_steps(Marks& marks) {
    const ColorScale& scale = marks.scale;
    const int stride = (scale.steps + most_labels - 1) / most_labels;
    const double span = scale.log ? 0 : static_cast<double>(scale.range[1]) - scale.range[0];
    for (int k = 0; k <= scale.steps; ++k)
        marks.add(value_at(scale, static_cast<double>(k) / scale.steps), k % stride == 0, span);
}

// 1, 2, 3 ... 9 times each power of ten; `with` of them have labels, on every `stride`-th power.
void add_decades(Marks& marks, double low, double high, const std::vector<int>& with, int stride) {
    const int first = static_cast<int>(std::floor(std::log10(low)));
    const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
    const bool has_marks = last - first <= most_marked_decades;
    for (int decade = first; decade <= last; ++decade)
        for (int multiple = 1; multiple <= (has_marks ? 9 : 1); ++multiple) {
            const double value = rounded(multiple * std::pow(10, decade));
            if (value < low * (1 - 1e-6) || value > high * (1 + 1e-6)) continue;
            const bool is_labelled = std::find(with.begin(), with.end(), multiple) != with.end();
            marks.add(value, is_labelled && decade % stride == 0, 0);
        }
}

int labels_of(const std::vector<ColorTick>& ticks) {
    return static_cast<int>(
        std::count_if(ticks.begin(), ticks.end(), [](const ColorTick& t) { return !t.label.empty(); }));
}

void add_log(Marks& marks, int wanted) {
    const double low = marks.scale.range[0];
    const double high = marks.scale.range[1];
    const int decades = static_cast<int>(std::floor(std::log10(high / low)));
    const int stride = std::max(1, (decades + most_labels - 1) / most_labels);
    for (const std::vector<int>& with : {std::vector<int>{1}, std::vector<int>{1, 2, 5}}) {
        marks.ticks.clear();
        add_decades(marks, low, high, with, stride);
        if (labels_of(marks.ticks) >= 3) return;
    }
    marks.ticks.clear();
    for (const double value : round_values(low, high, wanted)) marks.add(value, true, high - low);
}

} // namespace

std::vector<ColorTick> color_ticks(const ColorScale& scale, int wanted) {
    Marks marks{scale, {}};
    const double low = scale.range[0];
    const double high = scale.range[1];
    if (!has_width(scale))
        marks.add(low, true, 0);
    else if (scale.steps > 1)
        add_steps(marks);
    else if (scale.log)
        add_log(marks, wanted);
    else
        for (const double value : round_values(low, high, wanted)) marks.add(value, true, high - low);
    return std::move(marks.ticks);
}

std::string value_label(double value, double span) {
    if (!std::isfinite(value)) return "n/a";
    if (value == 0) return "0";
    const double size = std::abs(value);
    const double resolution = (span > 0 && std::isfinite(span) ? span : size) / 1000;
    const int places = static_cast<int>(std::floor(std::log10(size)));
    const int wanted = places - static_cast<int>(std::floor(std::log10(resolution))) + 1;
    const int digits = std::min(15, std::max({1, wanted, size < 1e6 ? places + 1 : 1})); // never a rounded whole number
    const bool has_exponent = size >= 1e6 || size < 1e-4;
    char text[48];
    if (has_exponent)
        std::snprintf(text, sizeof text, "%.*e", std::min(digits - 1, 5), size);
    else
        std::snprintf(text, sizeof text, "%.*f", std::max(0, digits - 1 - places), size);
    std::string mantissa = text;
    std::string exponent;
    if (const auto e = mantissa.find('e'); e != std::string::npos) {
        const int power = std::atoi(mantissa.c_str() + e + 1);
        exponent = (power < 0 ? "e\u2212" : "e") + std::to_string(std::abs(power));
        mantissa.resize(e);
    }
    if (mantissa.find('.') != std::string::npos) {
        mantissa.erase(mantissa.find_last_not_of('0') + 1);
        if (mantissa.back() == '.') mantissa.pop_back();
    }
    return (value < 0 ? "\u2212" : "") + mantissa + exponent;
}

} // namespace ciel::render
