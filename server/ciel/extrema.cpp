// Sorted local minima (paper, section 2.2), and maxima for sweeping downwards. The order (value, id) leaves no ties: a
// plateau has exactly the extrema that its rim needs.
#include "ciel/blocks.hpp"
#include "ciel/field_blocks.hpp"
#include "ciel/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace ciel {

namespace {

void mark(std::uint8_t& flag) { std::atomic_ref(flag).store(1, std::memory_order_relaxed); }

// An edge rules its upper end out as a minimum and its lower end as a maximum.
void rule_out(const Block& block, std::span<const float> values, std::vector<std::uint8_t>& not_minimum,
              std::vector<std::uint8_t>& not_maximum) {
    block.with([&](const auto& arrays) {
        for (std::size_t e = 0; e < arrays.edge_low.size(); ++e) {
            const auto a = arrays.edge_low[e], b = arrays.edge_high[e]; // the id of a is the lower one
            if (std::isnan(values[a]) || std::isnan(values[b])) continue;
            const bool upward = values[a] <= values[b];
            mark(not_minimum[block.vertex[upward ? b : a]]);
            mark(not_maximum[block.vertex[upward ? a : b]]);
        }
    });
}

} // namespace

void Field::Blocks::make_extrema() const {
    const Locked lock(extrema_mutex);
    if (extrema_made) return;
    extrema_made = true;
    const Topology::Blocks& all = topology->blocks();
    std::vector<std::uint8_t> not_minimum(values.size(), 0), not_maximum(values.size(), 0);
    parallel_for(all.block.size(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b)
            rule_out(all.block[b], of_block(static_cast<Index>(b)), not_minimum, not_maximum);
    });
    for (Index v = 0; v < values.size(); ++v) {
        if (!std::isfinite(values[v]) || all.first_slot[v] == none) continue;
        if (!not_minimum[v]) minima.push_back(v);
        if (!not_maximum[v]) maxima.push_back(v);
    }
    const auto below = [this](Index a, Index b) { return values[a] != values[b] ? values[a] < values[b] : a < b; };
    std::ranges::sort(minima, below);
    std::ranges::sort(maxima, [&](Index a, Index b) { return below(b, a); });
}

} // namespace ciel
