#include "ciel/field.hpp"

#include "blocks/blocks.hpp"
#include "ciel/parallel.hpp"
#include "ciel/point_interpolation.hpp"
#include "fields/field_data.hpp"
#include "fields/stored_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel {

Field::Field(const Topology& topology, std::span<const float> values, std::shared_ptr<const void> keep_alive)
    : Field(topology, values, block_ranges(topology, values), std::move(keep_alive)) {}

Field::Field(const Topology& topology, std::span<const float> values, BlockRanges ranges,
             std::shared_ptr<const void> keep_alive)
    : data_(std::make_shared<Data>()) {
    if (values.size() != topology.counts().vertices) fail("the values belong to another mesh");
    data_->values = values;
    data_->keep_alive = std::move(keep_alive);
    data_->begin(topology, std::move(ranges));
    const BlockRanges& of_blocks = data_->of_blocks;
    if (of_blocks.low.empty()) return;
    const float low = *std::ranges::min_element(of_blocks.low), high = *std::ranges::max_element(of_blocks.high);
    if (low <= high) data_->range = {low, high};
}

Field Field::plane(const Topology& topology, const FaceMeshView& points, const Vec3d& origin, const Vec3d& normal,
                   const BlockBoxes& boxes, std::shared_ptr<const void> keep_alive) {
    if (points.vertex_count() != topology.counts().vertices) fail("the points belong to another mesh");
    Field field;
    field.data_ = std::make_shared<Data>();
    Data& out = *field.data_;
    out.plane.emplace(points, origin, normal);
    out.keep_alive = std::move(keep_alive);
    out.begin(topology, out.plane->ranges(boxes));
    out.range = out.plane->range(out.of_blocks, topology.blocks().numbers.vertex);
    return field;
}

void Field::Data::begin(const Topology& of, BlockRanges block_ranges) {
    const Topology::Blocks& all = of.blocks();
    if (block_ranges.low.size() != all.count() || block_ranges.high.size() != all.count() ||
        block_ranges.missing.size() != all.count())
        fail("the ranges belong to another mesh");
    topology = &of;
    // Untouched pages take no memory. After the last block, a changed record may name any local vertex of 16 bits.
    local = std::make_unique_for_overwrite<float[]>(all.slot_count() + local_ids);
    taken = std::make_unique<std::atomic<bool>[]>(all.count());
    ranges.resize(all.count());
    of_blocks = std::move(block_ranges);
}

void Field::Data::take_in(Index b) const {
    const Locked lock(take_in_mutex[b % take_in_mutex.size()]);
    if (taken[b].load(std::memory_order_relaxed)) return;
    const Block& block = topology->blocks().cells(b);
    float* to = local.get() + block.vertex_begin;
    block.ghost_vertex.for_each([&](Index vertex) { *to++ = value(vertex); });
    const std::size_t own = block.vertex_count - block.ghost_vertex.size();
    if (plane)
        for (std::size_t v = 0; v < own; ++v) *to++ = plane->at(block.own_vertex_begin + v);
    else
        to = std::ranges::copy(values.subspan(block.own_vertex_begin, own), to).out;
    if (has_gaps(b))
        for (float* each = local.get() + block.vertex_begin; each < to; ++each)
            if (!std::isfinite(*each)) *each = std::numeric_limits<float>::quiet_NaN();
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
float Field::value(Index vertex) const { return data_->value(vertex); }
std::array<float, 2> Field::range() const { return data_->range; }

void Field::set_direction(std::shared_ptr<const GeometricVertices> where, Vec3d normal) {
    data_->where_extrema = std::move(where);
    data_->direction_length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
}

void Field::take_in() const {
    parallel_for(data_->of_blocks.low.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) (void)data_->of_block(static_cast<Index>(b));
    });
}

void Field::vertices_moved() { data_->gradients.forget(); }

std::span<const Index> Field::sorted_minima() const {
    data_->make_extrema();
    return data_->minima;
}

} // namespace ciel
