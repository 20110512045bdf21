#include "ciel/block_ranges.hpp"

#include "blocks/blocks.hpp"
#include "ciel/parallel.hpp"
#include "parallel/vector_units.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace ciel {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// [min, max] as integers that sort like the floats. The integers of non-finite values lie outside those of all finite
// values. Integer min and max do not depend on the order of the values, so the compiler can vectorize the loop.
struct Range {
    std::int32_t low = std::numeric_limits<std::int32_t>::max(), high = std::numeric_limits<std::int32_t>::min();
};

// Maps float bits to integers that sort like the floats. The function is its own inverse.
constexpr std::int32_t in_order(std::int32_t bits) {
    return bits ^ (bits >> 31 & std::numeric_limits<std::int32_t>::max());
}
constexpr std::int32_t above_all = std::bit_cast<std::int32_t>(infinity),
                       below_all = in_order(above_all ^ std::numeric_limits<std::int32_t>::min());

// Extends `out` by `count` values. Vectorized, because it runs over every value of a new field.
CIEL_FOR_ALL_VECTOR_UNITS void widen(const float* from, std::size_t count, Range& out) {
    std::int32_t low = out.low, high = out.high;
    for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t key = in_order(std::bit_cast<std::int32_t>(from[i]));
        low = key < low ? key : low;
        high = key > high ? key : high;
    }
    out = {low, high};
}

// Calls f(values, count) over all of a block's values. The values of ghosts are copied into batches; the values of
// owned vertices are contiguous and come last, in one call.
template <class F>
void for_values(const Block& block, std::span<const float> values, F&& f) {
    std::array<float, 256> some;
    std::size_t count = 0;
    block.ghost_vertex.for_each([&](Index vertex) {
        some[count++] = values[vertex];
        if (count < some.size()) return;
        f(some.data(), count);
        count = 0;
    });
    f(some.data(), count);
    const std::size_t ghosts = block.ghost_vertex.size();
    f(values.data() + block.own_vertex_begin, block.vertex_count - ghosts);
}

void range_of_block(const Block& block, std::span<const float> values, std::size_t b, BlockRanges& out) {
    Range range;
    for_values(block, values, [&](const float* from, std::size_t count) { widen(from, count, range); });
    if (range.low <= below_all || range.high >= above_all) {
        range = {};
        for_values(block, values, [&](const float* from, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i)
                std::isfinite(from[i]) ? widen(from + i, 1, range) : void(++out.missing[b]);
        });
    }
    const bool empty = range.low > range.high;
    out.low[b] = empty ? infinity : std::bit_cast<float>(in_order(range.low));
    out.high[b] = empty ? -infinity : std::bit_cast<float>(in_order(range.high));
}

} // namespace

BlockRanges block_ranges(const Topology& topology, std::span<const float> values) {
    if (values.size() != topology.counts().vertices)
        fail("a field must hold one value per vertex (" + std::to_string(topology.counts().vertices) + "), not " +
             std::to_string(values.size()));
    const Topology::Blocks& all = topology.blocks();
    BlockRanges out;
    out.low.resize(all.count());
    out.high.resize(all.count());
    out.missing.resize(all.count());
    parallel_for(all.count(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) range_of_block(all.cells(static_cast<Index>(b)), values, b, out);
    });
    return out;
}

BlockBoxes block_boxes(const Topology& topology, std::span<const float> positions) {
    BlockBoxes boxes;
    std::vector<float> of_axis(positions.size() / 3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t v = 0; v < of_axis.size(); ++v) of_axis[v] = positions[3 * v + axis];
        boxes[axis] = block_ranges(topology, of_axis);
    }
    return boxes;
}

} // namespace ciel
