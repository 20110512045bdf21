#include "ciel/block_scan.hpp"

#include <algorithm>
#include <cmath>

namespace ciel {

CutScratch& scratch_of_this_thread() {
    static thread_local CutScratch scratch;
    return scratch;
}

bool classify(std::span<const float> values, float threshold, CutScratch& scratch, CutBlock& cut) {
    const std::size_t words = (values.size() + 63) / 64;
    if (scratch.high.size() < 64 * words) scratch.high.resize(64 * words);
    for (std::size_t v = 0; v < values.size(); ++v) scratch.high[v] = values[v] >= threshold ? 1 : 0;
    std::fill(scratch.high.begin() + static_cast<std::ptrdiff_t>(values.size()),
              scratch.high.begin() + static_cast<std::ptrdiff_t>(64 * words), std::uint8_t{0});
    bool same = cut.known;
    cut.signature.resize(words);
    for (std::size_t w = 0; w < words; ++w) {
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < 64; ++i) bits |= std::uint64_t{scratch.high[64 * w + i]} << i;
        same = same && cut.signature[w] == bits;
        cut.signature[w] = bits;
    }
    return same;
}

namespace {

template <class Local>
void list_active_edges(const BlockArrays<Local>& arrays, std::span<const float> values, bool gaps,
                       const CutScratch& scratch, CutBlock& cut) {
    const std::size_t edges = arrays.edge_low.size();
    cut.active.resize(edges);
    std::size_t count = 0;
    for (std::size_t e = 0; e < edges; ++e) { // without a branch: which edges are active is unpredictable
        cut.active[count] = static_cast<Index>(e);
        count += scratch.high[arrays.edge_low[e]] ^ scratch.high[arrays.edge_high[e]];
    }
    cut.active.resize(count);
    if (gaps)
        std::erase_if(cut.active, [&](Index e) {
            return std::isnan(values[arrays.edge_low[e]]) || std::isnan(values[arrays.edge_high[e]]);
        });
}

// Each corner whose edge is active is an entry on one side: side 0 where its vertex is low, else side 1. A tail face
// has only one of them in this block.
template <class Local>
void list_entries(const Block& block, const BlockArrays<Local>& arrays, CutScratch& scratch, const CutBlock& cut) {
    scratch.on.assign(arrays.edge_low.size(), 0);
    for (const Index e : cut.active) scratch.on[e] = 1;
    const std::size_t corners = arrays.edge.size();
    scratch.entry.resize(corners);
    std::size_t count = 0;
    for (std::size_t k = 0; k < corners; ++k) {
        scratch.entry[count] = static_cast<Index>(k);
        count += scratch.on[arrays.edge[k]];
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Index corner = scratch.entry[i];
        const Index side = scratch.high[arrays.vertex[corner]];
        const bool here = corner < block.inner_corners || side == Index{corner >= block.far_corner};
        scratch.entry[kept] = block.half_edge(corner, side);
        kept += here ? 1 : 0;
    }
    scratch.entry.resize(kept);
}

} // namespace

void cut_classified(const Block& block, std::span<const float> values, bool gaps, CutScratch& scratch, CutBlock& cut) {
    block.with([&](const auto& arrays) {
        list_active_edges(arrays, values, gaps, scratch, cut);
        list_entries(block, arrays, scratch, cut);
        walk_entries(block, arrays, values, gaps, scratch, cut);
    });
}

} // namespace ciel
