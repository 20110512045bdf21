#include "ciel/field.hpp"

#include "ciel/blocks.hpp"
#include "ciel/field_blocks.hpp"
#include "ciel/parallel.hpp"
#include "ciel/vector_units.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace ciel {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// [min, max] as integers of the same order: the same in whatever order values are looked at, so that the compiler may
// look at many at once. What is not finite is beyond all that is.
struct Range {
    std::int32_t low = std::numeric_limits<std::int32_t>::max(), high = std::numeric_limits<std::int32_t>::min();
};

// Its own inverse.
constexpr std::int32_t in_order(std::int32_t bits) {
    return bits ^ (bits >> 31 & std::numeric_limits<std::int32_t>::max());
}
constexpr std::int32_t above_all = std::bit_cast<std::int32_t>(infinity),
                       below_all = in_order(above_all ^ std::numeric_limits<std::int32_t>::min());

// The loop that meets every value of a new field.
CIEL_FOR_ALL_VECTOR_UNITS void widen(const float* from, std::size_t count, Range& out) {
    std::int32_t low = out.low, high = out.high;
    for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t key = in_order(std::bit_cast<std::int32_t>(from[i]));
        low = key < low ? key : low;
        high = key > high ? key : high;
    }
    out = {low, high};
}

// Calls f(values, count) for all of a block's: what other blocks own lies anywhere, its own one after another.
template <class F>
void for_values(const Block& block, std::span<const float> values, F&& f) {
    std::array<float, 256> some;
    const std::size_t ghosts = block.ghost_vertex.size();
    for (std::size_t begin = 0; begin < ghosts; begin += some.size()) {
        const std::size_t count = std::min(some.size(), ghosts - begin);
        for (std::size_t i = 0; i < count; ++i) some[i] = values[block.ghost_vertex[begin + i]];
        f(some.data(), count);
    }
    f(values.data() + block.own_vertex_begin, block.vertex_count - ghosts);
}

void range_of_block(const Block& block, Index b, Field::Blocks& out) {
    Range range;
    for_values(block, out.values, [&](const float* from, std::size_t count) { widen(from, count, range); });
    out.gaps[b] = range.low <= below_all || range.high >= above_all ? 1 : 0;
    if (out.gaps[b] != 0) {
        range = {};
        for_values(block, out.values, [&](const float* from, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i)
                if (std::isfinite(from[i])) widen(from + i, 1, range);
        });
    }
    const bool empty = range.low > range.high;
    out.low[b] = empty ? infinity : std::bit_cast<float>(in_order(range.low));
    out.high[b] = empty ? -infinity : std::bit_cast<float>(in_order(range.high));
}

} // namespace

Field::Field(const Topology& topology, std::span<const float> values, std::shared_ptr<const void> keep_alive)
    : blocks_(std::make_unique<Blocks>()) {
    if (values.size() != topology.counts().vertices)
        fail("a field must hold one value per vertex (" + std::to_string(topology.counts().vertices) + "), not " +
             std::to_string(values.size()));
    const std::vector<Block>& all = topology.blocks().block;
    Blocks& out = *blocks_;
    out.topology = &topology;
    out.values = values;
    out.keep_alive = std::move(keep_alive);
    const std::size_t slots = all.empty() ? 0 : std::size_t{all.back().vertex_begin} + all.back().vertex_count;
    out.local = std::make_unique_for_overwrite<float[]>(slots); // what is not looked at costs no memory either
    out.taken = std::make_unique<std::atomic<bool>[]>(all.size());
    out.low.resize(all.size());
    out.high.resize(all.size());
    out.gaps.resize(all.size());
    out.ranges.resize(all.size());
    parallel_for(all.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) range_of_block(all[b], static_cast<Index>(b), out);
    });
    const float low = all.empty() ? infinity : *std::ranges::min_element(out.low);
    const float high = all.empty() ? -infinity : *std::ranges::max_element(out.high);
    if (low <= high) out.range = {low, high};
}

void Field::Blocks::take_in(Index b) const {
    const Locked lock(take_in_mutex[b % take_in_mutex.size()]);
    if (taken[b].load(std::memory_order_relaxed)) return;
    const Block& block = topology->blocks().block[b];
    float* to = local.get() + block.vertex_begin;
    for (const Index vertex : block.ghost_vertex) *to++ = values[vertex];
    const std::span own = values.subspan(block.own_vertex_begin, block.vertex_count - block.ghost_vertex.size());
    to = std::ranges::copy(own, to).out;
    if (gaps[b] != 0)
        for (float* value = local.get() + block.vertex_begin; value < to; ++value)
            if (!std::isfinite(*value)) *value = std::numeric_limits<float>::quiet_NaN();
    taken[b].store(true, std::memory_order_release);
}

Field::~Field() = default;
Field::Field(Field&&) noexcept = default;
Field& Field::operator=(Field&&) noexcept = default;

std::span<const float> Field::values() const { return blocks_->values; }
std::array<float, 2> Field::range() const { return blocks_->range; }

void Field::set_direction(std::shared_ptr<const GeometricVertices> where, Vec3d normal) {
    blocks_->where_extrema = std::move(where);
    blocks_->direction_length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
}

void Field::vertices_moved() { blocks_->gradients.forget(); }

std::span<const Index> Field::sorted_minima() const {
    blocks_->make_extrema();
    return blocks_->minima;
}

} // namespace ciel
