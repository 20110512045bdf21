#include "geometry/cut.hpp"

#include "ciel/contour_lines.hpp"
#include "ciel/polygon_edges.hpp"
#include "geometry/sound_shape.hpp"
#include "geometry/surface_values.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

namespace server::geometry {
std::uint64_t unique_number() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

namespace {

store::Values same_value(std::size_t count, double value, bool doubles) {
    if (doubles) return store::Values(std::vector<double>(count, value));
    return store::Values(std::vector<float>(count, static_cast<float>(value)));
}

store::Association association_of(const store::Dataset& dataset, const std::string& scalar) {
    return dataset.find(store::parse_scalar(dataset, scalar).array)->association;
}

// Returns the middle of the finite doubles, or 0 for floats. The result is subtracted before values become floats.
double origin_of(const store::Values& values) {
    if (!values.has_doubles()) return 0;
    double low = INFINITY, high = -INFINITY;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    return low <= high ? low / 2 + high / 2 : 0;
}

} // namespace

store::Values Painted::flat_scalars(store::LoadedDataset& loaded) const {
    const ciel::Surface& surface = flat->surface;
    const auto dataset = loaded.dataset();
    const store::Association association = association_of(*dataset, array);
    const auto values = loaded.stored_scalar(array, step, association);
    if (association == store::Association::cell) return flat_values(surface, values->of(surface.polygon_cell));
    const std::uint64_t on_boundary = dataset->info().meshes[dataset->steps()[step].mesh].boundary_faces;
    std::vector<ciel::Index> numbers = surface.polygon_face;
    for (ciel::Index& number : numbers)
        if (number >= on_boundary) number = ciel::none;
    return flat_values(surface, values->of(numbers));
}

void Painted::paint(const std::shared_ptr<const Shape>& new_shape, const std::string& new_array, std::size_t new_step,
                    store::LoadedDataset& loaded, const OfArray& of) {
    const bool same_step = (new_array.empty() && of.array.empty()) || new_step == step;
    if (revision != 0 && new_shape == shape && new_array == array && same_step) return;
    const std::array arrays{of.array, new_array};
    auto new_sound = sound_shape(new_shape, arrays, new_step, loaded);
    if (sound && shape == new_shape && new_sound != new_shape &&
        sound->surface.polygon_cell == new_sound->surface.polygon_cell)
        new_sound = sound; // the same cells are left out
    Painted made = *this;
    made.shape = new_shape;
    made.array = new_array;
    made.step = new_step;
    made.scalars = std::nullopt;
    made.flat = nullptr;
    if (!new_array.empty() && association_of(*loaded.dataset(), new_array) != store::Association::point) {
        made.flat = flat && new_sound == sound ? flat : separated(*new_sound);
        made.scalars = made.flat_scalars(loaded);
    } else if (!new_array.empty()) {
        const auto values = loaded.stored_scalar(new_array, new_step);
        const auto& points = new_sound->surface.points;
        made.scalars = of.value ? same_value(points.size(), *of.value, values->has_doubles()) : values->at(points);
    }
    made.sound = std::move(new_sound);
    const auto is_finite = [](auto value) { return std::isfinite(value); };
    made.missing = made.scalars && !made.scalars->with([&](auto all) { return std::ranges::all_of(all, is_finite); });
    made.scalar_origin = made.scalars ? origin_of(*made.scalars) : 0;
    made.revision = unique_number();
    *this = std::move(made);
}

void Outlined::follow(const std::shared_ptr<const Shape>& new_shape) {
    if (edges && shape == new_shape) return;
    shape = new_shape;
    edges = std::make_shared<const std::vector<ciel::Index>>(ciel::polygon_edges(shape->surface));
    revision = unique_number();
}

void Contoured::follow(const std::shared_ptr<const Shape>& shape, const std::string& new_array, std::size_t new_step,
                       const std::vector<double>& new_values, bool colored, store::LoadedDataset& loaded) {
    const bool is_colored = scalars.has_value();
    if (lines && of == shape && array == new_array && step == new_step && values == new_values && is_colored == colored)
        return;
    const auto sound = sound_shape(shape, std::span(&new_array, 1), new_step, loaded);
    const auto& points = sound->surface.points;
    const store::Values at_points = loaded.stored_scalar(new_array, new_step)->at(points);
    auto made = std::make_shared<Shape>();
    made->lines = true;
    auto& positions = made->surface.positions;
    std::vector<double> value_at_points;
    if (!colored) positions = ciel::contour_lines(sound->surface, at_points, new_values);
    for (std::size_t i = 0; colored && i < new_values.size(); ++i) {
        const auto of_value = ciel::contour_lines(sound->surface, at_points, std::span(&new_values[i], 1));
        positions.insert(positions.end(), of_value.begin(), of_value.end());
        value_at_points.resize(positions.size(), new_values[i]);
    }
    made->indices.resize(made->surface.positions.size());
    std::iota(made->indices.begin(), made->indices.end(), ciel::Index{0});
    of = shape;
    array = new_array;
    step = new_step;
    values = new_values;
    lines = std::move(made);
    scalars = colored ? std::optional(store::Values(std::move(value_at_points))) : std::nullopt;
    scalar_origin = scalars ? origin_of(*scalars) : 0;
    revision = unique_number();
}

std::size_t Contoured::memory_bytes() const {
    return (lines ? bytes_of(*lines) : 0) + (scalars ? scalars->size_bytes() : 0);
}

void Cut::use_field(const std::string& name, store::ScalarField new_field, ciel::Extraction extraction) {
    const bool same_topology = query && new_field.topology == field.topology;
    shape = nullptr;
    field_name.clear(); // stays empty if the code below throws
    if (!same_topology) {
        query.reset();
        field = std::move(new_field);
        query.emplace(field.query(extraction));
    } else { // the same topology, whose vertices may have moved
        new_field.set_in(*query);
        field = std::move(new_field);
    }
    field_name = name;
}

bool Cut::extract(double new_nu, bool new_normals, const std::stop_token& stop) {
    if (shape && nu == new_nu && normals == new_normals) return true;
    shape = nullptr;
    auto made = shapes->take();
    if (!query->extract(new_nu, new_normals, made->surface, stop)) return false;
    ciel::triangulate(made->surface, made->indices);
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
    const bool own = shape && shape != of; // a cap without a threshold has the shape of its Cut, which counts it
    return (own ? bytes_of(*shape) : 0) + painted.memory_bytes() + outlined.memory_bytes() + cells.size();
}

} // namespace server::geometry
