// Hash table of the edges that later blocks may share. Not in the paper, which has no blocks.
#pragma once

#include "ciel/types.hpp"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

namespace ciel::detail {

// Not thread-safe.
class OpenEdges {
public:
    using Ends = std::pair<Index, Index>; // the mesh vertices of an edge

    // Starts to load the place of the edge into the processor's cache, because the table is large.
    void fetch(const Ends& ends) const {
        if (!slots_.empty()) __builtin_prefetch(&slots_[first_slot(ends)]);
    }
    // Returns the mesh-wide id of the edge, or none.
    [[nodiscard]] Index find(const Ends& ends) const { return slots_.empty() ? none : slots_[slot_of(ends)].edge; }
    // Adds a new edge. is_open(vertex) returns whether a later block has the vertex. When the table is full, edges with
    // an end that no later block has are dropped.
    template <class IsOpen>
    void add(const Ends& ends, Index edge, IsOpen&& is_open) {
        if (2 * (count_ + 1) > slots_.size()) drop_closed(is_open);
        slots_[slot_of(ends)] = {ends, edge};
        ++count_;
    }

private:
    struct Slot {
        Ends ends{none, none};
        Index edge = none;
    };

    [[nodiscard]] std::size_t first_slot(const Ends& ends) const {
        const std::uint64_t key = std::uint64_t{ends.first} << 32 | ends.second;
        return (key * 0x9e3779b97f4a7c15U) >> shift_;
    }

    // Returns the index of the edge, or of the free slot for it.
    [[nodiscard]] std::size_t slot_of(const Ends& ends) const {
        std::size_t at = first_slot(ends);
        while (slots_[at].edge != none && slots_[at].ends != ends) at = (at + 1) & (slots_.size() - 1);
        return at;
    }
    template <class IsOpen>
    void drop_closed(IsOpen&& is_open) {
        constexpr std::size_t fewest_slots = 1024;
        std::vector<Slot> before;
        before.swap(slots_);
        std::erase_if(before, [&](const Slot& slot) {
            return slot.edge == none || !is_open(slot.ends.first) || !is_open(slot.ends.second);
        });
        count_ = before.size();
        slots_.resize(std::bit_ceil(std::max(fewest_slots, 4 * (count_ + 1))));
        shift_ = 64 - std::countr_zero(slots_.size());
        for (const Slot& slot : before) slots_[slot_of(slot.ends)] = slot;
    }

    std::vector<Slot> slots_; // open addressing; the size is a power of two
    int shift_ = 0;           // 64 - the logarithm of the size
    std::size_t count_ = 0;
};

} // namespace ciel::detail
