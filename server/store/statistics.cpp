#include "store/statistics.hpp"

#include "store/format/checksum.hpp"
#include "store/no_value.hpp"

#include <algorithm>
#include <cmath>

namespace server::store {
namespace {

// The range of values. For each end, also keeps the first item with this value.
class Range {
public:
    void add(double value, ciel::Index item) {
        if (value < low_) {
            low_ = value;
            lowest_ = item;
        }
        if (value > high_) {
            high_ = value;
            highest_ = item;
        }
    }
    [[nodiscard]] bool empty() const { return low_ > high_; }
    [[nodiscard]] std::array<double, 2> get() const { return empty() ? std::array{0.0, 0.0} : std::array{low_, high_}; }
    [[nodiscard]] CellExtremes extremes() const { return {{lowest_, {}}, {highest_, {}}}; }

private:
    double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
    ciel::Index lowest_ = 0, highest_ = 0;
};

// Returns no extremes if a component has no finite value, because the index of an entry tells its component.
std::vector<CellExtremes> extremes_of(const Range& all, const std::vector<Range>& of_component) {
    const auto is_empty = [](const Range& range) { return range.empty(); };
    if (all.empty() || std::ranges::any_of(of_component, is_empty)) return {};
    std::vector<CellExtremes> extremes{all.extremes()};
    if (of_component.size() > 1)
        for (const Range& range : of_component) extremes.push_back(range.extremes());
    return extremes;
}

template <class T>
ArrayStep statistics_of(std::span<const T> values, const ArrayInfo& array) {
    const auto width = static_cast<std::size_t>(array.components);
    const bool by_magnitude = width > 1 && has_magnitude(array);
    std::vector<Range> of_component(width);
    Range all;
    ArrayStep result;
    for (std::size_t at = 0; at + width <= values.size(); at += width) {
        const auto item = static_cast<ciel::Index>(at / width);
        for (std::size_t c = 0; c < width; ++c) {
            const double value = values[at + c];
            if (!std::isfinite(value)) {
                ++(is_no_value(value) ? result.missing : result.invalid);
                continue;
            }
            of_component[c].add(value, item);
            if (!by_magnitude) all.add(value, item);
        }
        if (!by_magnitude) continue;
        // Rounds the magnitude to T, as scalars_in does.
        const auto magnitude = static_cast<T>(magnitude_of(array, values.subspan(at, width)));
        if (std::isfinite(magnitude)) all.add(magnitude, item);
    }
    for (const Range& range : of_component) result.component_ranges.push_back(range.get());
    result.range = all.get();
    if (array.association == Association::cell) result.extremes = extremes_of(all, of_component);
    return result;
}

} // namespace

ArrayStep statistics(ciel::ValuesView values, const ArrayInfo& array) {
    return values.with([&](auto all) { return statistics_of(all, array); });
}

ValueRanges value_ranges(ciel::ValuesView values, const ArrayInfo& array, const ciel::Topology& topology) {
    ValueRanges ranges;
    for (const ScalarName& name : scalars_of(array)) {
        const Values scalar = one_scalar(array, values, name);
        const bool on_points = array.association == Association::point;
        ranges.scalars.push_back(on_points ? ciel::block_ranges(topology, scalar) : ciel::BlockRanges{});
        ranges.histograms.push_back(histogram_of(scalar, stored_bins));
    }
    ranges.stretch_checksums = stretch_checksums(values.bytes());
    return ranges;
}

} // namespace server::store
