// [min, max] of a field over groups of a block's cells: a cut skips groups whose range excludes nu. Not in the paper.
#pragma once

#include "blocks/blocks.hpp"
#include "ciel/values_view.hpp"

#include <atomic>
#include <memory>

namespace ciel::detail {

// Thread-safe. The ranges of a block are built at its second cut: a field that is shown once does not need them.
class CellRanges {
public:
    // [min, max] of the finite values in a group of cells of a standard section, or in one polyhedron. For doubles,
    // both ends are rounded outwards to floats. low > high when there are no finite values.
    using Range = std::array<float, 2>;

    void resize(std::size_t blocks);
    // Returns the ranges of the groups of the standard sections, then those of the polyhedra. Returns an empty span at
    // the first call for a block, and while another thread builds its ranges. `values`: by local vertex; NaN: no value.
    [[nodiscard]] std::span<const Range> of(const Block& block, Index b, ValuesView values);

private:
    enum State : std::uint8_t { never_asked, asked_once, in_the_making, made };
    class Making;
    std::unique_ptr<std::atomic<std::uint8_t>[]> state_;
    std::vector<std::vector<Range>> ranges_;
};

} // namespace ciel::detail
