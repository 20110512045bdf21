// SharedEdges and MetEdges: two ways to record the active edges of a cut, instead of the is_marked of the paper's
// half-edge (section 2.2, figure 3).
#pragma once

#include "extraction/cut_block.hpp"

#include <algorithm>

namespace ciel::detail {

// Records active edges for surfaces whose points are shared between blocks. Polygons store local edge ids.
class SharedEdges {
public:
    explicit SharedEdges(CutScratch& scratch) : active_(scratch.active.data()), ends_(scratch.ends.data()) {}

    // Marks the edge between the local vertices a and b as active. Returns the id that polygons store.
    Index activate(Index edge, Index a, Index b) {
        active_[edge / 64] |= std::uint64_t{1} << edge % 64;
        ends_[edge] = {std::min(a, b), std::max(a, b)};
        return edge;
    }
    // has: returns whether an edge is active. kept: returns the id that polygons store for an active edge.
    [[nodiscard]] bool has(Index edge) const { return (active_[edge / 64] >> edge % 64 & 1) != 0; }
    [[nodiscard]] static Index kept(Index edge) { return edge; }
    void finish() const {}

private:
    std::uint64_t* active_;
    std::array<Index, 2>* ends_;
};

// Records active edges for the cut of one block alone. Polygons store point numbers, in the order of first use.
class MetEdges {
public:
    explicit MetEdges(CutScratch& scratch)
        : met_(scratch.met.data()), ends_(scratch.ends.data()), before_(scratch.met_before), count_(&scratch.met_count),
          next_(scratch.met_before + scratch.met_count) {}

    // Returns the number of the edge's point. Has no branch: always writes the ends of a new point. If the edge already
    // has a point, the next new point overwrites these ends.
    Index activate(Index edge, Index a, Index b) {
        const Index known = met_[edge], is_new = known < before_ ? 1 : 0;
        const Index number = known ^ ((known ^ next_) & (0 - is_new));
        met_[edge] = number;
        ends_[next_ - before_] = {std::min(a, b), std::max(a, b)};
        next_ += is_new;
        return number - before_;
    }
    [[nodiscard]] bool has(Index edge) const { return met_[edge] >= before_; }
    [[nodiscard]] Index kept(Index edge) const { return met_[edge] - before_; }
    void finish() const { *count_ = next_ - before_; }

private:
    Index* met_;
    std::array<Index, 2>* ends_;
    Index before_;
    Index* count_;
    Index next_; // before_ + the number of points so far
};

} // namespace ciel::detail
