#include "store/format/histogram.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace server::store {

void Histogram::add(ciel::ValuesView values) {
    const double low = range[0], high = range[1];
    const auto bins = static_cast<double>(counts.size());
    const double scale = std::isfinite(high - low) ? 1 : 0.5; // halves all numbers if the width overflows a double
    const double width = high * scale - low * scale;
    values.with([&](const auto& all) {
        for (const double value : all) {
            if (!std::isfinite(value))
                ++invalid;
            else if (value < low)
                ++below;
            else if (value > high)
                ++above;
            else {
                const double place = width > 0 ? (value * scale - low * scale) / width * bins : 0;
                ++counts[static_cast<std::size_t>(std::min(place, bins - 1))];
            }
        }
    });
}

// The sums equal the counts of a histogram made with `bins` bins, because scaling by a power of two is exact.
std::optional<Histogram> Histogram::with_bins(std::size_t bins) const {
    if (bins == 0 || counts.size() % bins != 0 || !std::has_single_bit(counts.size() / bins)) return std::nullopt;
    Histogram fewer = *this;
    fewer.counts.assign(bins, 0);
    const std::size_t together = counts.size() / bins;
    for (std::size_t bin = 0; bin < counts.size(); ++bin) fewer.counts[bin / together] += counts[bin];
    return fewer;
}

double Histogram::quantile(double share) const {
    const std::uint64_t all = std::accumulate(counts.begin(), counts.end(), below + above);
    const double wanted = share * static_cast<double>(all);
    auto seen = static_cast<double>(below);
    for (std::size_t bin = 0; bin < counts.size(); ++bin) {
        const auto count = static_cast<double>(counts[bin]);
        if (count > 0 && seen + count >= wanted) {
            const double place = static_cast<double>(bin) + std::max(0.0, (wanted - seen) / count);
            return std::lerp(range[0], range[1], place / static_cast<double>(counts.size()));
        }
        seen += count;
    }
    return all == 0 ? range[0] : range[1];
}

void FiniteRange::add(ciel::ValuesView values) {
    values.with([&](const auto& all) {
        for (const double value : all)
            if (std::isfinite(value)) {
                low_ = std::min(low_, value);
                high_ = std::max(high_, value);
            }
    });
}

std::array<double, 2> FiniteRange::get() const { return low_ > high_ ? std::array{0.0, 0.0} : std::array{low_, high_}; }

Histogram histogram_of(ciel::ValuesView values, std::size_t bins) {
    FiniteRange range;
    range.add(values);
    Histogram histogram(range.get(), bins);
    histogram.add(values);
    return histogram;
}

} // namespace server::store
