#include "ciel/block_ranges.hpp"

#include "blocks/blocks.hpp"
#include "ciel/parallel.hpp"
#include "parallel/vector_units.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

namespace ciel {

using detail::Block;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Integers that have the same order as the numbers, so that the compiler can vectorize the search for the minimum.
// Infinities and NaN are below or above all finite values.
template <class Value>
using Key = std::conditional_t<std::same_as<Value, float>, std::int32_t, std::int64_t>;
template <class Value>
struct Range {
    Key<Value> low = std::numeric_limits<Key<Value>>::max(), high = std::numeric_limits<Key<Value>>::min();
};

// Converts the bits of a number to its Key. The function is its own inverse.
template <class K>
constexpr K in_order(K bits) {
    return bits ^ (bits >> (8 * sizeof(K) - 1) & std::numeric_limits<K>::max());
}
template <class Value>
constexpr auto above_all = std::bit_cast<Key<Value>>(std::numeric_limits<Value>::infinity());
template <class Value>
constexpr auto below_all = in_order<Key<Value>>(above_all<Value> ^ std::numeric_limits<Key<Value>>::min());

template <class Value>
inline __attribute__((always_inline)) void widen_all(const Value* from, std::size_t count, Range<Value>& out) {
    Key<Value> low = out.low, high = out.high;
    for (std::size_t i = 0; i < count; ++i) {
        const auto key = in_order(std::bit_cast<Key<Value>>(from[i]));
        low = key < low ? key : low;
        high = key > high ? key : high;
    }
    out = {low, high};
}

// Vectorized, because it reads every value of a new field.
CIEL_FOR_ALL_VECTOR_UNITS void widen(const float* from, std::size_t count, Range<float>& out) {
    widen_all(from, count, out);
}
CIEL_FOR_ALL_VECTOR_UNITS void widen(const double* from, std::size_t count, Range<double>& out) {
    widen_all(from, count, out);
}

// Calls f(pointer, count) with copies of the values of ghosts, then with the contiguous values of owned vertices.
template <class Value, class F>
void for_values(const Block& block, std::span<const Value> values, F&& f) {
    std::array<Value, 256> some;
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

template <class Value>
void range_of_block(const Block& block, std::span<const Value> values, std::size_t b, BlockRanges& out) {
    Range<Value> range;
    for_values(block, values, [&](const Value* from, std::size_t count) { widen(from, count, range); });
    if (range.low <= below_all<Value> || range.high >= above_all<Value>) {
        range = {};
        for_values(block, values, [&](const Value* from, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i)
                std::isfinite(from[i]) ? widen(from + i, 1, range) : void(++out.missing[b]);
        });
    }
    const bool empty = range.low > range.high;
    out.low[b] = empty ? infinity : std::bit_cast<Value>(in_order(range.low));
    out.high[b] = empty ? -infinity : std::bit_cast<Value>(in_order(range.high));
}

} // namespace

BlockRanges block_ranges(const Topology& topology, ValuesView values) {
    if (values.size() != topology.counts().vertices)
        fail("a field must hold one value per vertex (" + std::to_string(topology.counts().vertices) + "), not " +
             std::to_string(values.size()));
    const Topology::Blocks& all = topology.blocks();
    BlockRanges out;
    out.low.resize(all.count());
    out.high.resize(all.count());
    out.missing.resize(all.count());
    parallel_for(all.count(), 64, [&](std::size_t begin, std::size_t end) {
        values.with([&](const auto& typed) {
            for (std::size_t b = begin; b < end; ++b) range_of_block(all.cells(static_cast<Index>(b)), typed, b, out);
        });
    });
    return out;
}

BlockBoxes block_boxes(const Topology& topology, ValuesView positions) {
    BlockBoxes boxes;
    positions.with([&]<class Number>(std::span<const Number> all) {
        std::vector<Number> of_axis(all.size() / 3);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t v = 0; v < of_axis.size(); ++v) of_axis[v] = all[3 * v + axis];
            boxes[axis] = block_ranges(topology, of_axis);
        }
    });
    return boxes;
}

} // namespace ciel
