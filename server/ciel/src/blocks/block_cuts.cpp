#include "blocks/block_cuts.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ciel::detail {

void BlockCuts::keep(std::span<const Index> blocks) {
    const auto is_used = [&](Index b) { return std::ranges::binary_search(blocks, b); };
    std::erase_if(left_, is_used);
    std::ranges::set_difference(used_, blocks, std::back_inserter(left_));
    used_.assign(blocks.begin(), blocks.end());

    const std::size_t surplus = left_.size() - std::min(left_.size(), std::max(blocks.size(), always_kept));
    std::size_t taken = 0;
    for (const Index b : blocks) {
        if (cuts_[b]) continue;
        if (taken < surplus) {
            cuts_[b] = std::move(cuts_[left_[taken++]]);
            cuts_[b]->known = false;
        } else {
            cuts_[b] = std::make_unique<ActiveBlock>();
        }
    }
    for (; taken < surplus; ++taken) cuts_[left_[taken]].reset();
    left_.erase(left_.begin(), left_.begin() + static_cast<std::ptrdiff_t>(surplus));
}

void BlockCuts::forget() {
    for (const auto* blocks : {&used_, &left_})
        for (const Index b : *blocks) cuts_[b]->known = false;
}

std::size_t BlockCuts::memory_bytes() const {
    std::size_t sum = cuts_.capacity() * sizeof cuts_[0] + (used_.capacity() + left_.capacity()) * sizeof(Index);
    for (const auto* blocks : {&used_, &left_})
        for (const Index b : *blocks) {
            const ActiveBlock& cut = *cuts_[b];
            sum += sizeof(ActiveBlock) + sizeof(std::uint64_t) * (cut.signature.capacity() + cut.active.capacity()) +
                   sizeof(Index) *
                       (cut.rank.capacity() + 2 * cut.ends.capacity() + cut.adopted.capacity() +
                        cut.polygon_cell.capacity() + cut.polygon_end.capacity() + cut.polygon_edge.capacity());
        }
    return sum;
}

} // namespace ciel::detail
