#include "store/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace ciel::store {
namespace {

class Range {
public:
    void add(double value) {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
    [[nodiscard]] std::array<double, 2> get() const {
        return low_ <= high_ ? std::array{low_, high_} : std::array{0.0, 0.0};
    }

private:
    double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

} // namespace

ArrayStep statistics(std::span<const float> values, int components) {
    const auto width = static_cast<std::size_t>(components);
    std::vector<Range> of_component(width);
    Range of_magnitude;
    ArrayStep result;
    for (std::size_t at = 0; at + width <= values.size(); at += width) {
        double squares = 0;
        for (std::size_t c = 0; c < width; ++c) {
            const double value = values[at + c];
            if (std::isfinite(value))
                of_component[c].add(value);
            else
                ++result.invalid;
            squares += value * value;
        }
        if (std::isfinite(squares)) of_magnitude.add(std::sqrt(squares));
    }
    for (const Range& range : of_component) result.component_ranges.push_back(range.get());
    result.range = components == 1 ? result.component_ranges[0] : of_magnitude.get();
    return result;
}

} // namespace ciel::store
