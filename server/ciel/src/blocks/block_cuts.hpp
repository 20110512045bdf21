// BlockCuts: the cuts that a query keeps from one surface to the next (paper, algorithm 1: the active edges are kept).
#pragma once

#include "blocks/active_block.hpp"

#include <memory>
#include <span>
#include <vector>

namespace ciel {

// Keeps the cuts of the blocks that the surface crosses. Of the blocks that earlier surfaces crossed, keeps the cuts of
// at most as many, or of `always_kept` if that is more. So the memory depends on the current surface, not on all
// earlier ones. Not thread-safe, but different blocks may be used at the same time.
class BlockCuts {
public:
    static constexpr std::size_t always_kept = 1024; // about 10 MB

    explicit BlockCuts(std::size_t blocks) : cuts_(blocks) {}

    [[nodiscard]] std::size_t size() const { return cuts_.size(); } // number of blocks of the mesh
    // REQUIRES: the block was in the last call of `keep`.
    [[nodiscard]] ActiveBlock& operator[](Index block) { return *cuts_[block]; }
    [[nodiscard]] const ActiveBlock& operator[](Index block) const { return *cuts_[block]; }

    // Makes sure that each of `blocks` (ascending) has a cut. A block without a cut gets one that is not known
    // (ActiveBlock::known). It reuses the buffers of the blocks that the surface left first, if these need not be kept.
    void keep(std::span<const Index> blocks);
    void forget(); // marks all cuts as not known
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    std::vector<std::unique_ptr<ActiveBlock>> cuts_; // by block
    std::vector<Index> used_;                        // blocks of the last `keep`
    std::vector<Index> left_; // other blocks with a cut, in the order in which the surface left them
};

} // namespace ciel
