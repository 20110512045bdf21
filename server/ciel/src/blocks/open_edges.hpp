// Hash table of the edges that later blocks may share. Not in the paper, which has no blocks.
#pragma once

#include "ciel/types.hpp"

#include <bit>
#include <vector>

namespace ciel::detail {

// Not thread-safe.
class OpenEdges {
public:
    // Returns the mesh-wide id of the edge, or none. `low`, `high`: its mesh vertices.
    [[nodiscard]] Index find(Index low, Index high) const {
        return slots_.empty() ? none : slots_[slot_of(low, high)].edge;
    }
    // The edge must be new. is_open(vertex) returns whether a later block has the vertex; edges without such ends are
    // dropped when the table is full.
    template <class IsOpen>
    void add(Index low, Index high, Index edge, IsOpen&& is_open) {
        if (2 * (count_ + 1) > slots_.size()) drop_closed(is_open);
        slots_[slot_of(low, high)] = {low, high, edge};
        ++count_;
    }

private:
    struct Slot {
        Index low = none, high = none, edge = none;
    };

    // Returns the index of the edge, or of the free slot for it.
    [[nodiscard]] std::size_t slot_of(Index low, Index high) const {
        const std::uint64_t key = std::uint64_t{low} << 32 | high;
        std::size_t at = (key * 0x9e3779b97f4a7c15U) >> shift_;
        while (slots_[at].edge != none && (slots_[at].low != low || slots_[at].high != high))
            at = (at + 1) % slots_.size();
        return at;
    }
    template <class IsOpen>
    void drop_closed(IsOpen&& is_open) {
        constexpr std::size_t fewest_slots = 1024;
        std::vector<Slot> before;
        before.swap(slots_);
        std::erase_if(before,
                      [&](const Slot& slot) { return slot.edge == none || !is_open(slot.low) || !is_open(slot.high); });
        count_ = before.size();
        slots_.resize(std::bit_ceil(std::max(fewest_slots, 4 * (count_ + 1))));
        shift_ = 64 - std::countr_zero(slots_.size());
        for (const Slot& slot : before) slots_[slot_of(slot.low, slot.high)] = slot;
    }

    std::vector<Slot> slots_; // open addressing; the size is a power of two
    int shift_ = 0;           // 64 - the logarithm of the size
    std::size_t count_ = 0;
};

} // namespace ciel::detail
