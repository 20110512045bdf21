// [min, max] of a field over groups of a block's cells. Lets a cut skip groups whose range excludes nu. Not in the
// paper, which keeps minima for the whole mesh (section 2.2).
#pragma once

#include "blocks/blocks.hpp"

#include <atomic>
#include <memory>

namespace ciel {

// Thread-safe. A block's ranges are built when it is cut a second time: a field that is shown once does not need them.
class CellRanges {
public:
    // Of a group of cells of a standard section, or of one polyhedron. Finite values only; low > high when there are
    // none.
    using Range = std::array<float, 2>;

    // Makes room for this many blocks; builds no ranges.
    void resize(std::size_t blocks);
    // Ranges of the groups of the standard sections in order, then of the polyhedra. Empty at the first call for a
    // block, and while another thread builds them. `values`: the block's, NaN where a vertex has no value.
    [[nodiscard]] std::span<const Range> of(const Block& block, Index b, std::span<const float> values);

private:
    enum State : std::uint8_t { never_asked, asked_once, in_the_making, made };
    class Making;
    std::unique_ptr<std::atomic<std::uint8_t>[]> state_;
    std::vector<std::vector<Range>> ranges_;
};

} // namespace ciel
