#include "render/volume/volume_order.hpp"

#include <algorithm>
#include <cmath>

namespace ciel::render {
namespace {

double middle_of(std::span<const SlabRow> rows, const SlabOfVolume& which) {
    const SlabRow& row = rows[which.volume];
    return row.first + (static_cast<double>(which.slab) + 0.5) * row.thickness;
}

// Every second place the other way round.
void take_turns(std::vector<SlabOfVolume>& sorted, std::span<const SlabRow> rows) {
    constexpr double rounding = 1e-6; // of a slab
    for (auto begin = sorted.begin(); begin != sorted.end();) {
        const double middle = middle_of(rows, *begin), near = rounding * rows[begin->volume].thickness;
        const auto end = std::find_if(
            begin, sorted.end(), [&](const auto& slab) { return std::abs(middle_of(rows, slab) - middle) > near; });
        std::sort(begin, end, [](const auto& a, const auto& b) { return a.volume < b.volume; });
        if (begin->slab % 2 == 1) std::reverse(begin, end);
        begin = end;
    }
}

} // namespace

std::vector<SlabOfVolume> back_to_front(std::span<const SlabRow> rows, double eye) {
    std::vector<SlabOfVolume> below, above;
    for (std::size_t volume = 0; volume < rows.size(); ++volume) {
        const auto& [first, thickness, count] = rows[volume];
        const double place = std::clamp(std::floor((eye - first) / thickness), 0.0, static_cast<double>(count));
        for (std::size_t slab = 0; slab < count; ++slab)
            (slab < static_cast<std::size_t>(place) ? below : above).push_back({volume, slab});
    }
    std::ranges::stable_sort(below, {}, [&](const auto& slab) { return middle_of(rows, slab); });
    std::ranges::stable_sort(above, {}, [&](const auto& slab) { return -middle_of(rows, slab); });
    take_turns(below, rows);
    take_turns(above, rows);
    below.insert(below.end(), above.begin(), above.end());
    return below;
}

} // namespace ciel::render
