#include "fields/cell_ranges.hpp"

#include <algorithm>
#include <cmath>

namespace ciel::detail {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr CellRanges::Range nothing{infinity, -infinity};

// Ignores NaN, because comparisons with NaN are false.
void widen(CellRanges::Range& range, float value) {
    range[0] = value < range[0] ? value : range[0];
    range[1] = value > range[1] ? value : range[1];
}
void widen(CellRanges::Range& range, double value) {
    const auto nearest = static_cast<float>(value);
    widen(range, nearest);
    if (nearest > value) widen(range, std::nextafter(nearest, -infinity));
    if (nearest < value) widen(range, std::nextafter(nearest, infinity));
}

template <class Value>
void append(const StandardSection& section, std::span<const Value> values, std::vector<CellRanges::Range>& out) {
    const std::size_t per_group = std::size_t{StandardSection::cells_per_group} * section.shape->corners;
    for (std::size_t begin = 0; begin < section.vertex.size(); begin += per_group) {
        CellRanges::Range range = nothing;
        for (std::size_t i = begin; i < std::min(begin + per_group, section.vertex.size()); ++i)
            widen(range, values[section.vertex[i]]);
        out.push_back(range);
    }
}

template <class Local, class Value>
void append(const PolyhedralSection<Local>& section, std::span<const Value> values,
            std::vector<CellRanges::Range>& out) {
    const std::size_t begin = out.size();
    out.resize(begin + section.count(), nothing);
    for (Index face = 0, k = 0; face < section.face_count(); ++face) {
        CellRanges::Range range = nothing;
        for (const Index end = read_once(section.face_begin[face + 1]); k < end; ++k)
            widen(range, values[section.vertex[k]]);
        if (!(range[0] <= range[1])) continue; // no finite value on the face
        for (const Index cell : section.face_cell[face]) {
            // In a changed record, `cell` may be out of range.
            CellRanges::Range& widened = out[begin + std::min(cell, section.count() - 1)];
            widen(widened, range[0]);
            widen(widened, range[1]);
        }
    }
}

} // namespace

// Sets a block's state on destruction: asked_once if an allocation threw, so that the next call tries again.
class CellRanges::Making {
public:
    explicit Making(std::atomic<std::uint8_t>& state) : state_(state) {}
    ~Making() { state_.store(result, std::memory_order_release); }
    Making(const Making&) = delete;

    State result = asked_once;

private:
    std::atomic<std::uint8_t>& state_;
};

void CellRanges::resize(std::size_t blocks) {
    state_ = std::make_unique<std::atomic<std::uint8_t>[]>(blocks);
    ranges_.resize(blocks);
}

std::span<const CellRanges::Range> CellRanges::of(const Block& block, Index b, ValuesView values) {
    std::uint8_t state = state_[b].load(std::memory_order_acquire);
    if (state == made) return ranges_[b];
    if (state == in_the_making) return {};
    const auto next = static_cast<std::uint8_t>(state + 1);
    if (!state_[b].compare_exchange_strong(state, next, std::memory_order_acquire) || next == asked_once) return {};
    Making making(state_[b]);
    ranges_[b].clear();
    values.with([&](const auto& all) {
        for (const StandardSection& section : block.standard) append(section, all, ranges_[b]);
        block.with([&](const auto& polyhedra) { append(polyhedra, all, ranges_[b]); });
    });
    making.result = made;
    return ranges_[b];
}

} // namespace ciel::detail
