#include "ciel/field.hpp"

#include "ciel/blocks.hpp"
#include "ciel/field_blocks.hpp"
#include "ciel/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

void gather_block(const Block& block, Index b, Field::Blocks& out) {
    float low = infinity, high = -infinity;
    bool gaps = false;
    float* to = out.local.get() + block.vertex_begin;
    for (Index local = 0; local < block.vertex_count; ++local) {
        float value = out.values[block.vertex(local)];
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        } else {
            value = std::numeric_limits<float>::quiet_NaN();
            gaps = true;
        }
        *to++ = value;
    }
    out.low[b] = low;
    out.high[b] = high;
    out.gaps[b] = gaps ? 1 : 0;
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
