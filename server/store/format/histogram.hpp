// Histogram: the number of values of a scalar in each bin. All bins have the same width.
#pragma once

#include "ciel/values_view.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace server::store {

inline constexpr std::size_t stored_bins = 256;

// A bin includes its lower end and excludes its upper end. The last bin includes both ends.
struct Histogram {
    Histogram() = default;
    Histogram(const std::array<double, 2>& of_range, std::size_t bins) : range(of_range), counts(bins) {}

    // If both ends are equal, values equal to them are in the first bin.
    std::array<double, 2> range{};
    std::vector<std::uint64_t> counts;
    std::uint64_t below = 0, above = 0; // finite values outside the range
    std::uint64_t invalid = 0;          // NaN and infinite values

    void add(ciel::ValuesView values);

    // Returns this histogram with only `bins` bins; nullopt unless it has `bins` times a power of two bins.
    [[nodiscard]] std::optional<Histogram> with_bins(std::size_t bins) const;
    // Returns the value below which `share` (0 to 1) of the finite values lie. Assumes that the values of a bin are
    // spread evenly over the bin. Returns the lower end of the range if there are no finite values.
    [[nodiscard]] double quantile(double share) const;

    [[nodiscard]] bool operator==(const Histogram&) const = default;
};

class FiniteRange {
public:
    void add(ciel::ValuesView values);
    [[nodiscard]] std::array<double, 2> get() const; // {0, 0} if no value is finite

private:
    double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

// Returns the histogram over the range [min, max] of the finite values.
[[nodiscard]] Histogram histogram_of(ciel::ValuesView values, std::size_t bins);

} // namespace server::store
