// [min, max] of a field over groups of a block's cells, so that a value far from most of a block's is quick there. Not
// in the paper, which keeps minima for all of a mesh (section 2.2).
#pragma once

#include "blocks/blocks.hpp"

#include <atomic>
#include <memory>

namespace ciel {

// Made for a block the second time that it is cut: a field that is looked at once would pay for nothing. Any thread.
class CellRanges {
public:
    // Of a group of cells of a standard section, or of a polyhedron. Finite values only; low > high where there are
    // none.
    using Range = std::array<float, 2>;

    // Room for so many blocks; nothing is made.
    void resize(std::size_t blocks);
    // The groups of the standard sections one after another, then the polyhedra; empty the first time, and while
    // another thread makes them. `values`: the block's, NaN where there is none.
    [[nodiscard]] std::span<const Range> of(const Block& block, Index b, std::span<const float> values);

private:
    enum State : std::uint8_t { never_asked, asked_once, in_the_making, made };
    class Making;
    std::unique_ptr<std::atomic<std::uint8_t>[]> state_;
    std::vector<std::vector<Range>> ranges_;
};

} // namespace ciel
