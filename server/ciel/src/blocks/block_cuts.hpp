// BlockCuts: the cuts that a query keeps from one surface to the next (paper, algorithm 1: the active edges are kept).
#pragma once

#include "blocks/active_block.hpp"

#include <memory>
#include <span>
#include <vector>

namespace ciel::detail {

// Keeps the cuts of the N blocks that the current surface crosses, and at most max(N, always_kept) cuts of other blocks
// that earlier surfaces crossed. Not thread-safe, but several threads may use different blocks at the same time.
class BlockCuts {
public:
    static constexpr std::size_t always_kept = 1024; // number of blocks; their cuts take about 10 MB

    explicit BlockCuts(std::size_t blocks) : cuts_(blocks) {}

    [[nodiscard]] std::size_t size() const { return cuts_.size(); } // number of blocks of the mesh
    // REQUIRES: the block was one of `blocks` in the last call of `keep`.
    [[nodiscard]] ActiveBlock& operator[](Index block) { return *cuts_[block]; }
    [[nodiscard]] const ActiveBlock& operator[](Index block) const { return *cuts_[block]; }

    // Ensures that each of `blocks` (ascending) has a cut. A new cut has `known` set to false. If more cuts exist than
    // must be kept, a new cut reuses the buffers of one of them. The cut of the block that the surface left earliest is
    // reused first.
    void keep(std::span<const Index> blocks);
    void forget(); // sets `known` of all cuts to false
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    std::vector<std::unique_ptr<ActiveBlock>> cuts_; // by block
    std::vector<Index> used_;                        // blocks of the last `keep`
    std::vector<Index> left_; // other blocks with a cut, in the order in which the surface left them
};

} // namespace ciel::detail
