#include "ciel/field.hpp"

#include "blocks/blocks.hpp"
#include "ciel/parallel.hpp"
#include "ciel/point_interpolation.hpp"
#include "fields/cell_fits.hpp"
#include "fields/field_data.hpp"
#include "fields/stored_values.hpp"

#include <algorithm>

namespace ciel {

using namespace detail;

Field::Field(const Topology& topology, ValuesView values, std::shared_ptr<const void> keep_alive)
    : Field(topology, values, block_ranges(topology, values), std::move(keep_alive)) {}

Field::Field(const Topology& topology, ValuesView values, BlockRanges ranges, std::shared_ptr<const void> keep_alive)
    : data_(std::make_shared<Data>()) {
    if (values.size() != topology.counts().vertices)
        fail("the values belong to another mesh; pass one value per vertex of the topology");
    if (!keep_alive) fail("the values of the field have no owner; pass the object that owns the array");
    data_->values = values;
    data_->keep_alive = std::move(keep_alive);
    data_->begin(topology, std::move(ranges));
    data_->range = data_->range_of_blocks();
}

Field::Field(const Topology& topology, std::shared_ptr<const ValueSource> source, BlockRanges ranges)
    : data_(std::make_shared<Data>()) {
    if (source->size() != topology.counts().vertices)
        fail("the values belong to another mesh; pass one value per vertex of the topology");
    data_->source = std::move(source);
    data_->begin(topology, std::move(ranges));
    data_->range = data_->range_of_blocks();
}

Field Field::plane(const Topology& topology, const FaceMeshView& points, const Vec3d& origin, const Vec3d& normal,
                   const BlockBoxes& boxes) {
    if (points.vertex_count() != topology.counts().vertices)
        fail("the points belong to another mesh; pass one point per vertex of the topology");
    Field field;
    field.data_ = std::make_shared<Data>();
    Data& out = *field.data_;
    out.plane.emplace(points, origin, normal);
    out.keep_alive = points.owned().keep_alive;
    out.begin(topology, out.plane->ranges(boxes));
    out.range = out.plane->range(out.of_blocks, topology.blocks().numbers.vertex);
    return field;
}

template <class T>
Field::Field(const Mesh& mesh, const std::shared_ptr<const std::vector<T>>& stored)
    : Field(mesh.topology(), ValuesView(*stored), stored) {
    data_->mesh = mesh;
    data_->fits = mesh.cell_fits();
}

Field::Field(const Mesh& mesh, const ArrayView& values) {
    StoredValues(mesh, values, PerItem::point).with([&]<class T>(std::vector<T>& stored) {
        *this = Field(mesh, std::make_shared<const std::vector<T>>(std::move(stored)));
    });
}

Field Field::from_cells(const Mesh& mesh, const ArrayView& values) {
    return StoredValues(mesh, values, PerItem::cell).with([&]<class T>(const std::vector<T>& of_cells) {
        const PointInterpolation points(mesh.topology(), mesh.stored());
        return Field(mesh, std::make_shared<const std::vector<T>>(points.apply(std::span<const T>(of_cells), 1)));
    });
}

Field Field::plane(const Mesh& mesh, const Vec3d& origin, const Vec3d& normal) {
    if (mesh.stored().positions.has_doubles())
        return {mesh,
                std::make_shared<const std::vector<double>>(plane_distances<double>(mesh.stored(), origin, normal))};
    return {mesh, std::make_shared<const std::vector<float>>(plane_distances<float>(mesh.stored(), origin, normal))};
}

const Mesh* Field::mesh() const { return data_->mesh ? &*data_->mesh : nullptr; }

Field::~Field() = default;
Field::Field(const Field&) = default;
Field& Field::operator=(const Field&) = default;
Field::Field(Field&&) noexcept = default;
Field& Field::operator=(Field&&) noexcept = default;

ValuesView Field::values() const { return data_->source ? ValuesView() : data_->values; }
double Field::value(Index vertex) const { return data_->value_alone(vertex); }
std::array<double, 2> Field::range() const { return data_->range; }

void Field::set_direction(std::shared_ptr<const GeometricVertices> where, Vec3d normal) {
    data_->where_extrema = std::move(where);
    data_->direction_length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
}

void Field::take_in() const {
    parallel_for(data_->of_blocks.low.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) (void)data_->of_block(static_cast<Index>(b));
    });
}

void Field::set_cell_fits(std::shared_ptr<CellFits> fits) {
    if (fits && !data_->is_of(fits->data().topology))
        fail("the cell fits belong to another mesh; make them from the topology of the field");
    data_->fits = std::move(fits);
}

void Field::vertices_moved() {
    data_->gradients.forget();
    data_->fits.reset();
}

std::span<const Index> Field::sorted_minima() const {
    data_->make_extrema();
    return data_->minima;
}

} // namespace ciel
