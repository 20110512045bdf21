#include "ciel/field.hpp"

#include "blocks/blocks.hpp"
#include "ciel/parallel.hpp"
#include "ciel/point_interpolation.hpp"
#include "fields/field_data.hpp"
#include "fields/stored_values.hpp"
#include "parallel/vector_units.hpp"

#include <algorithm>
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

void range_of_block(const Block& block, Index b, Field::Data& out) {
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
    : data_(std::make_shared<Data>()) {
    if (values.size() != topology.counts().vertices)
        fail("a field must hold one value per vertex (" + std::to_string(topology.counts().vertices) + "), not " +
             std::to_string(values.size()));
    const Topology::Blocks& all = topology.blocks();
    Data& out = *data_;
    out.topology = &topology;
    out.values = values;
    out.keep_alive = std::move(keep_alive);
    out.local = std::make_unique_for_overwrite<float[]>(all.slot_count()); // untouched pages take no memory
    out.taken = std::make_unique<std::atomic<bool>[]>(all.count());
    out.low.resize(all.count());
    out.high.resize(all.count());
    out.gaps.resize(all.count());
    out.ranges.resize(all.count());
    parallel_for(all.count(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b)
            range_of_block(all.cells(static_cast<Index>(b)), static_cast<Index>(b), out);
    });
    const float low = all.count() == 0 ? infinity : *std::ranges::min_element(out.low);
    const float high = all.count() == 0 ? -infinity : *std::ranges::max_element(out.high);
    if (low <= high) out.range = {low, high};
}

void Field::Data::take_in(Index b) const {
    const Locked lock(take_in_mutex[b % take_in_mutex.size()]);
    if (taken[b].load(std::memory_order_relaxed)) return;
    const Block& block = topology->blocks().cells(b);
    float* to = local.get() + block.vertex_begin;
    block.ghost_vertex.for_each([&](Index vertex) { *to++ = values[vertex]; });
    const std::span own = values.subspan(block.own_vertex_begin, block.vertex_count - block.ghost_vertex.size());
    to = std::ranges::copy(own, to).out;
    if (gaps[b] != 0)
        for (float* value = local.get() + block.vertex_begin; value < to; ++value)
            if (!std::isfinite(*value)) *value = std::numeric_limits<float>::quiet_NaN();
    taken[b].store(true, std::memory_order_release);
}

Field::Field(const Mesh& mesh, const ArrayView& values)
    : Field(mesh, std::make_shared<const std::vector<float>>(stored_values(mesh, values, PerItem::point))) {}

// The vector owns the values and is kept alive by the field. data_->mesh keeps the topology alive.
Field::Field(const Mesh& mesh, const std::shared_ptr<const std::vector<float>>& stored)
    : Field(mesh.topology(), *stored, stored) {
    data_->mesh = mesh;
}

Field Field::from_cells(const Mesh& mesh, const ArrayView& values) {
    const std::vector<float> of_cells = stored_values(mesh, values, PerItem::cell);
    return {mesh, std::make_shared<const std::vector<float>>(PointInterpolation(mesh.stored()).apply(of_cells, 1))};
}

Field Field::plane(const Mesh& mesh, const Vec3d& origin, const Vec3d& normal) {
    return {mesh, std::make_shared<const std::vector<float>>(plane_distance(mesh.stored(), origin, normal))};
}

const Mesh* Field::mesh() const { return data_->mesh ? &*data_->mesh : nullptr; }

Field::~Field() = default;
Field::Field(const Field&) = default;
Field& Field::operator=(const Field&) = default;
Field::Field(Field&&) noexcept = default;
Field& Field::operator=(Field&&) noexcept = default;

std::span<const float> Field::values() const { return data_->values; }
std::array<float, 2> Field::range() const { return data_->range; }

void Field::set_direction(std::shared_ptr<const GeometricVertices> where, Vec3d normal) {
    data_->where_extrema = std::move(where);
    data_->direction_length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
}

void Field::take_in() const {
    parallel_for(data_->low.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) (void)data_->of_block(static_cast<Index>(b));
    });
}

void Field::vertices_moved() { data_->gradients.forget(); }

std::span<const Index> Field::sorted_minima() const {
    data_->make_extrema();
    return data_->minima;
}

} // namespace ciel
