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
    template <class Local>
    void cut_anew(const Block& block, const BlockArrays<Local>& arrays, std::span<const float> values, float threshold,
                  bool gaps, CutScratch& scratch, CutBlock& cut);

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
void list_active_edges(const Block& block, const BlockArrays<Local>& arrays, std::span<const float> values, bool gaps,
                       CutScratch& scratch, CutBlock& cut) {
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
    cut.owned = static_cast<Index>(std::ranges::lower_bound(cut.active, block.owned_edges) - cut.active.begin());
}

template <class Local>
void list_cut_cells(const Block& block, const BlockArrays<Local>& arrays, CutScratch& scratch) {
    scratch.cells.clear();
    const auto cut_face = [&](Index face) {
        for (Index k = block.face_begin[face]; k < block.face_begin[face + 1]; ++k)
            if (scratch.slot[arrays.edge[k]] != none) return true;
        return false;
    };
    for (Index cell = 0; cell < block.cell_count; ++cell)
        for (Index i = block.cell_face_begin[cell]; i < block.cell_face_begin[cell + 1]; ++i)
            if (cut_face(arrays.cell_face[i] / 2)) {
                scratch.cells.push_back(cell);
                break;
            }
}

template <class Local>
void SignatureCutter::cut_anew(const Block& block, const BlockArrays<Local>& arrays, std::span<const float> values,
                               float threshold, bool gaps, CutScratch& scratch, CutBlock& cut) {
    list_active_edges(block, arrays, values, gaps, scratch, cut);
    if (scratch.slot.size() < arrays.edge_low.size()) scratch.slot.resize(arrays.edge_low.size(), none);
    for (Index i = 0; i < cut.active.size(); ++i) scratch.slot[cut.active[i]] = i;
    list_cut_cells(block, arrays, scratch);
    walk_cells(block, arrays, values, threshold, gaps, scratch.cells, scratch, cut);
    for (const Index e : cut.active) scratch.slot[e] = none;
}

void SignatureCutter::cut_block(Index b, float threshold) {
    const Block& block = topology_.blocks().block[b];
    CutBlock& cut = cut_[b];
    CutScratch& scratch = scratch_of_this_thread();
    const std::span<const float> values = field_->of_block(b);
    const bool gaps = field_->gaps[b] != 0;
    if (classify(values, threshold, scratch, cut) && !gaps) return;
    block.with([&](const auto& arrays) { cut_anew(block, arrays, values, threshold, gaps, scratch, cut); });
    cut.known = !gaps;
}

} // namespace

std::unique_ptr<Cutter> make_signature_cutter(const Topology& topology) {
    return std::make_unique<SignatureCutter>(topology);
}

} // namespace ciel
