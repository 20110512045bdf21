#include "ciel/field.hpp"

#include "ciel/blocks.hpp"
#include "ciel/field_blocks.hpp"
#include "ciel/parallel.hpp"
#include "ciel/vector_units.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// Of the finite values; as many side by side as the widest vector unit holds.
struct Ranges {
    static constexpr std::size_t lanes = 16;
    float low[lanes], high[lanes];
    std::uint32_t gaps[lanes] = {};

    Ranges() {
        std::ranges::fill(low, infinity);
        std::ranges::fill(high, -infinity);
    }
};

// The loop that meets every value of a new field.
CIEL_FOR_ALL_VECTOR_UNITS void take_in(const float* from, std::size_t count, float* to, Ranges& out) {
    const auto take = [&](std::size_t i, std::size_t lane) {
        const float value = from[i];
        const bool is_finite = std::abs(value) <= std::numeric_limits<float>::max();
        const float taken = is_finite ? value : std::numeric_limits<float>::quiet_NaN();
        out.low[lane] = taken < out.low[lane] ? taken : out.low[lane]; // false for NaN, which leaves it out
        out.high[lane] = taken > out.high[lane] ? taken : out.high[lane];
        out.gaps[lane] |= is_finite ? 0U : 1U;
        to[i] = taken;
    };
    std::size_t i = 0;
    for (; i + Ranges::lanes <= count; i += Ranges::lanes)
        for (std::size_t lane = 0; lane < Ranges::lanes; ++lane) take(i + lane, lane);
    for (; i < count; ++i) take(i, 0);
}

// What other blocks own lies anywhere, its own vertices one after another.
void gather_block(const Block& block, Index b, Field::Blocks& out) {
    float* to = out.local.get() + block.vertex_begin;
    const std::size_t ghosts = block.ghost_vertex.size();
    Ranges ranges;
    for (std::size_t i = 0; i < ghosts; ++i) to[i] = out.values[block.ghost_vertex[i]];
    take_in(to, ghosts, to, ranges);
    take_in(out.values.data() + block.own_vertex_begin, block.vertex_count - ghosts, to + ghosts, ranges);
    out.low[b] = *std::ranges::min_element(ranges.low);
    out.high[b] = *std::ranges::max_element(ranges.high);
    out.gaps[b] = std::ranges::any_of(ranges.gaps, [](std::uint32_t gap) { return gap != 0; }) ? 1 : 0;
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
    out.local = std::make_unique_for_overwrite<float[]>(slots); // each thread touches its own part first
    out.low.resize(all.size());
    out.high.resize(all.size());
    out.gaps.resize(all.size());
    out.ranges.resize(all.size());
    parallel_for(all.size(), 32, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) gather_block(all[b], static_cast<Index>(b), out);
    });
    const float low = all.empty() ? infinity : *std::ranges::min_element(out.low);
    const float high = all.empty() ? -infinity : *std::ranges::max_element(out.high);
    if (low <= high) out.range = {low, high};
}

Field::~Field() = default;
Field::Field(Field&&) noexcept = default;
Field& Field::operator=(Field&&) noexcept = default;

std::span<const float> Field::values() const { return blocks_->values; }
std::array<float, 2> Field::range() const { return blocks_->range; }

void Field::vertices_moved() { blocks_->gradients.forget(); }

std::span<const Index> Field::sorted_minima() const {
    blocks_->make_extrema();
    return blocks_->minima;
}

} // namespace ciel
