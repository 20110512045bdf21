// How a cut records its active edges, and the ids that polygons store for them. The bits replace the is_marked of the
// paper's half-edge (section 2.2, figure 3).
#pragma once

#include "extraction/cut_block.hpp"

#include <algorithm>

namespace ciel {

// For surfaces: one bit per edge. Points are in the order of edges and shared between blocks.
class SharedEdges {
public:
    SharedEdges(CutScratch& scratch, ActiveBlock& cut) : active_(cut.active.data()), ends_(scratch.ends.data()) {}

    // Returns the id that a polygon stores.
    Index activate(Index edge, Index a, Index b) {
        active_[edge / 64] |= std::uint64_t{1} << edge % 64;
        ends_[edge] = {std::min(a, b), std::max(a, b)};
        return edge;
    }
    [[nodiscard]] static Index kept(Index edge) { return edge; }
    void finish() const {}

private:
    std::uint64_t* active_;
    std::array<Index, 2>* ends_;
};

// For points of one block: numbered in the order of first use, so that inactive edges cost nothing.
class MetEdges {
public:
    MetEdges(CutScratch& scratch, ActiveBlock&)
        : met_(scratch.met.data()), ends_(scratch.ends.data()), before_(scratch.met_before), count_(&scratch.met_count),
          next_(scratch.met_before + scratch.met_count) {}

    // Branch-free: whether the edge is new is unpredictable. Ends of a known edge are written past the last entry.
    Index activate(Index edge, Index a, Index b) {
        const Index known = met_[edge], is_new = known < before_ ? 1 : 0;
        const Index number = known ^ ((known ^ next_) & (0 - is_new));
        met_[edge] = number;
        ends_[next_ - before_] = {std::min(a, b), std::max(a, b)};
        next_ += is_new;
        return number - before_;
    }
    [[nodiscard]] Index kept(Index edge) const { return met_[edge] - before_; }
    void finish() const { *count_ = next_ - before_; }

private:
    Index* met_;
    std::array<Index, 2>* ends_;
    Index before_;
    Index* count_;
    Index next_; // number of the next point, plus before_
};

} // namespace ciel
