#include "ciel/cutter.hpp"
#include "ciel/field_blocks.hpp"
#include "ciel/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace ciel {

namespace {

CutScratch& scratch_of_this_thread() {
    static thread_local CutScratch scratch;
    return scratch;
}

class SignatureCutter : public Cutter {
public:
    using Cutter::Cutter;

    void set_field(const Field& field) override { field_ = &field.blocks(); }
    bool update(double nu, const std::stop_token& stop) override;

private:
    void cut_block(Index b, float threshold);
    const Field::Blocks* field_ = nullptr;
};

bool SignatureCutter::update(double nu, const std::stop_token& stop) {
    const float threshold = threshold_of(nu);
    active_.clear();
    for (Index b = 0; b < cut_.size(); ++b)
        if (field_->low[b] < threshold && field_->high[b] >= threshold) active_.push_back(b);
    parallel_for(active_.size(), 2, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !stop.stop_requested(); ++i) cut_block(active_[i], threshold);
    });
    return !stop.stop_requested();
}

// Classifies into bytes and bits; true when the bits are the ones the cut was made for. (Bits do not tell a vertex
// without a value from a low one: the caller never trusts them where there are such.)
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

void SignatureCutter::cut_block(Index b, float threshold) {
    const Block& block = topology_.blocks().block[b];
    CutBlock& cut = cut_[b];
    CutScratch& scratch = scratch_of_this_thread();
    const std::span<const float> values = field_->of_block(b);
    const bool gaps = field_->gaps[b] != 0;
    if (classify(values, threshold, scratch, cut) && !gaps) return;
    block.with([&](const auto& arrays) {
        list_active_edges(arrays, values, gaps, scratch, cut);
        list_entries(block, arrays, scratch, cut);
        walk_entries(block, arrays, values, gaps, scratch, cut);
    });
    cut.known = !gaps;
}

} // namespace

std::unique_ptr<Cutter> make_signature_cutter(const Topology& topology) {
    return std::make_unique<SignatureCutter>(topology);
}

} // namespace ciel
