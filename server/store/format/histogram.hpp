// Histogram: how many values of a scalar lie in each of the equal bins of a range.
#pragma once

#include "ciel/values_view.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace ciel::store {

inline constexpr std::size_t stored_bins = 256; // of the histograms beside arrays (README.md, "Ranges")

// A bin is [low, high); the last one includes its upper end.
struct Histogram {
    Histogram() = default;
    Histogram(const std::array<double, 2>& of_range, std::size_t bins) : range(of_range), counts(bins) {}

    std::array<double, 2> range{};      // of all bins; if both ends are equal, that value is in the first bin
    std::vector<std::uint64_t> counts;  // by bin
    std::uint64_t below = 0, above = 0; // finite values outside the range
    std::uint64_t invalid = 0;          // NaN and infinite values

    void add(ValuesView values);

    // Returns the histogram that counting with fewer bins gives; nullopt unless `bins` is the number of bins of this
    // one divided by a power of two.
    [[nodiscard]] std::optional<Histogram> with_bins(std::size_t bins) const;
    // Returns the value below which a share of the finite values lie, from 0 to 1, as if the values of a bin were
    // evenly spread over it. The lower end of the range if there are no finite values.
    [[nodiscard]] double quantile(double share) const;

    [[nodiscard]] bool operator==(const Histogram&) const = default;
};

// [min, max] of the finite values that were added.
class FiniteRange {
public:
    void add(ValuesView values);
    [[nodiscard]] std::array<double, 2> get() const; // {0, 0} if no value is finite

private:
    double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

// Returns the histogram over the range of the finite values.
[[nodiscard]] Histogram histogram_of(ValuesView values, std::size_t bins);

} // namespace ciel::store
