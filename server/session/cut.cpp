#include "session/cut.hpp"

#include "ciel/contour_lines.hpp"
#include "ciel/polygon_edges.hpp"
#include "session/flat_shape.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace ciel::session {
std::uint64_t unique_number() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

namespace {

bool is_of_cells(const store::Dataset& dataset, const std::string& scalar) {
    const std::string array = store::parse_scalar(dataset, scalar).array;
    return dataset.find(array)->association == store::Association::cell;
}

} // namespace

void Painted::paint(const std::shared_ptr<const Shape>& new_shape, const std::string& new_array, std::size_t new_step,
                    store::LoadedDataset& loaded, std::optional<double> own) {
    const bool same_step = new_array.empty() || new_step == step;
    if (revision != 0 && new_shape == shape && new_array == array && same_step) return;
    std::shared_ptr<std::vector<float>> values;
    std::shared_ptr<const Shape> new_flat;
    if (!new_array.empty() && is_of_cells(*loaded.dataset(), new_array)) {
        const auto of_cells = loaded.cell_values(new_array, new_step);
        new_flat = flat && new_shape == shape ? flat : separated(*new_shape);
        values = std::make_shared<std::vector<float>>(flat_values(new_flat->surface, *of_cells));
    } else if (!new_array.empty()) {
        const auto& points = new_shape->surface.points;
        values = std::make_shared<std::vector<float>>(points.size());
        if (own)
            std::fill(values->begin(), values->end(), static_cast<float>(*own));
        else
            interpolate(points, *loaded.scalar_values(new_array, new_step), 1, *values);
    }
    shape = new_shape;
    flat = std::move(new_flat);
    array = new_array;
    step = new_step;
    missing = values && !std::all_of(values->begin(), values->end(), [](float value) { return std::isfinite(value); });
    scalars = std::move(values);
    revision = unique_number();
}

void Outlined::follow(const std::shared_ptr<const Shape>& new_shape) {
    if (edges && shape == new_shape) return;
    shape = new_shape;
    edges = std::make_shared<const std::vector<Index>>(polygon_edges(shape->surface));
    revision = unique_number();
}

void Contoured::follow(const std::shared_ptr<const Shape>& shape, const std::string& new_array, std::size_t new_step,
                       const std::vector<double>& new_values, bool coloured, store::LoadedDataset& loaded) {
    const bool is_coloured = scalars != nullptr;
    if (lines && of == shape && array == new_array && step == new_step && values == new_values &&
        is_coloured == coloured)
        return;
    const auto& points = shape->surface.points;
    std::vector<float> at_points(points.size());
    interpolate(points, *loaded.scalar_values(new_array, new_step), 1, at_points);
    auto made = std::make_shared<Shape>();
    made->lines = true;
    auto& positions = made->surface.positions;
    auto value_at_points = coloured ? std::make_shared<std::vector<float>>() : nullptr;
    if (!coloured) positions = contour_lines(shape->surface, at_points, new_values);
    for (std::size_t i = 0; coloured && i < new_values.size(); ++i) {
        const auto of_value = contour_lines(shape->surface, at_points, std::span(&new_values[i], 1));
        positions.insert(positions.end(), of_value.begin(), of_value.end());
        value_at_points->resize(positions.size(), static_cast<float>(new_values[i]));
    }
    made->indices.resize(made->surface.positions.size());
    std::iota(made->indices.begin(), made->indices.end(), Index{0});
    of = shape;
    array = new_array;
    step = new_step;
    values = new_values;
    lines = std::move(made);
    scalars = std::move(value_at_points);
    revision = unique_number();
}

std::size_t Contoured::memory_bytes() const {
    return (lines ? bytes_of(*lines) : 0) + (scalars ? scalars->size() * sizeof(float) : 0);
}

void Cut::use_field(const std::string& name, store::ScalarField new_field, Extraction extraction) {
    const bool same_topology = query && new_field.topology == field.topology;
    shape = nullptr;
    field_name.clear(); // until all has gone well
    if (!same_topology) {
        query.reset(); // before the field it reads goes
        field = std::move(new_field);
        query.emplace(*field.topology, field.mesh, extraction);
        query->set_field(*field.field);
    } else { // its vertices may have moved
        query->set_mesh(new_field.mesh);
        query->set_field(*new_field.field);
        field = std::move(new_field);
    }
    field_name = name;
}

bool Cut::extract(double new_nu, bool new_normals, const std::stop_token& stop) {
    if (shape && nu == new_nu && normals == new_normals) return true;
    shape = nullptr;
    auto made = shapes->take();
    if (!query->extract(new_nu, new_normals, made->surface, stop)) return false;
    triangulate(made->surface, made->indices);
    nu = new_nu;
    normals = new_normals;
    shape = std::move(made);
    return true;
}

void Cut::show(std::shared_ptr<const Shape> made, double at_nu) {
    shape = std::move(made);
    nu = at_nu;
    normals = false;
}

std::size_t Cut::memory_bytes() const {
    return (query ? query->memory_bytes() : 0) + (shape ? bytes_of(*shape) : 0) + shapes->memory_bytes() +
           painted.memory_bytes() + outlined.memory_bytes() + contoured.memory_bytes();
}

std::size_t Boundary::memory_bytes() const {
    const bool own = shape && shape != of; // a whole cap is counted with its cut
    return (own ? bytes_of(*shape) : 0) + painted.memory_bytes() + outlined.memory_bytes() + cells.size();
}

} // namespace ciel::session
