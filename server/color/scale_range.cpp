#include "color/scale_range.hpp"

#include <algorithm>
#include <cmath>

namespace server::color {
namespace {

constexpr double largest_of_range = 4e37; // greatest end of a range; 1 / (twice this number) is not subnormal
constexpr double smallest_of_log = 1e-37; // least end of a log range; graphics cards may treat smaller floats as 0
constexpr double log_ratio = 1e6;         // ratio of the ends of a log range if the data reach zero

double within_floats(double end) { return std::clamp(end, -largest_of_range, largest_of_range); }

} // namespace

std::array<double, 2> range_above_zero(std::array<double, 2> range) {
    auto [low, high] = range;
    if (!(high > 0)) return {1, 10}; // any valid range, because the scale shows no value (is_shown_by)
    if (!(low > 0)) low = high / log_ratio;
    return {std::max(low, smallest_of_log), std::max(high, smallest_of_log)};
}

std::array<double, 2> range_of(const RangeChoice& choice, std::array<double, 2> data) {
    const std::array<double, 2> ends = choice.given.value_or(data);
    const std::array<double, 2> range{within_floats(ends[0]), within_floats(ends[1])};
    if (choice.symmetric) {
        const double reach = std::max(std::abs(range[0]), std::abs(range[1]));
        return {-reach, reach};
    }
    return choice.log ? range_above_zero(range) : range;
}

bool is_shown_by(const RangeChoice& choice, std::array<double, 2> data) {
    return !choice.log || choice.symmetric || choice.given || data[1] > 0;
}

} // namespace server::color
