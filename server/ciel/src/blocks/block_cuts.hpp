// BlockCuts: the cuts that a query keeps from one surface to the next (paper, algorithm 1: the active edges are kept).
#pragma once

#include "blocks/active_block.hpp"

#include <memory>
#include <span>
#include <vector>

namespace ciel {

// Keeps the cuts of the blocks at the surface, and of as many or `always_kept` blocks that the surface has left. So its
// memory follows from the surface, and not from all that were shown before. Not thread-safe, but different blocks may
// be used at the same time.
class BlockCuts {
public:
    static constexpr std::size_t always_kept = 1024; // about 10 MB

    explicit BlockCuts(std::size_t blocks) : cuts_(blocks) {}

    [[nodiscard]] std::size_t size() const { return cuts_.size(); } // number of blocks of the mesh
    // REQUIRES: the last call of `keep` had the block.
    [[nodiscard]] ActiveBlock& operator[](Index block) { return *cuts_[block]; }
    [[nodiscard]] const ActiveBlock& operator[](Index block) const { return *cuts_[block]; }

    // Makes sure that each of these blocks, which ascend, has a cut. A block that had none gets the buffers of one that
    // the surface left long ago, and a cut that is not known.
    void keep(std::span<const Index> blocks);
    void forget(); // no cut is known any more
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    std::vector<std::unique_ptr<ActiveBlock>> cuts_; // by block
    std::vector<Index> used_;                        // blocks of the last `keep`
    std::vector<Index> left_;                        // other blocks with a cut; those left first are first
};

} // namespace ciel
