#include "probe/probe.hpp"

#include "store/no_value.hpp"

#include <algorithm>
#include <cmath>

namespace server::probe {
namespace {

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

// Returns whether the array has no values yet, because it has not been read from its source.
bool is_late(const store::Dataset& dataset, std::size_t step, const std::string& array) {
    const auto& arrays = dataset.steps()[step].arrays;
    const auto found = arrays.find(array);
    return found != arrays.end() && found->second.late;
}

// Looks for NaN and infinity in the cell array, because the values at corners may come from neighbor cells.
bool went_wrong(const store::Dataset& dataset, std::size_t step, const store::ArrayInfo& array, ciel::Index cell) {
    const std::string of_cells = store::cell_scalar(dataset, store::scalar_names(array).front());
    if (of_cells.empty()) return false;
    const store::ArrayInfo& cells = *dataset.find(store::parse_scalar(dataset, of_cells).array);
    if (is_late(dataset, step, cells.name)) return false;
    const store::ValuesToLoad values = dataset.values_to_load(cells.name, step);
    return values.file != nullptr && std::ranges::any_of(store::scalars_of(cells), [&](const store::ScalarName& name) {
               return !name.magnitude &&
                      store::went_wrong(store::StoredScalar(cells, name, values).of(std::span(&cell, 1))[0]);
           });
}

// `weights`: of the vertices, or 1 for one cell. If `is_wrong`, the scalars get no value.
void probe_array(const store::Dataset& dataset, std::size_t step, const store::ArrayInfo& array,
                 const ciel::VertexWeights& weights, bool is_wrong, Probed& out) {
    const store::ValuesToLoad values =
        is_late(dataset, step, array.name) ? store::ValuesToLoad{} : dataset.values_to_load(array.name, step);
    std::vector<ciel::Index> items;
    for (const auto& [item, share] : weights) items.push_back(item);
    for (const std::string& scalar : store::scalar_names(array)) {
        out.values[scalar] = std::nullopt;
        if (values.file == nullptr || is_wrong) continue;
        const store::Values of_items =
            store::StoredScalar(array, store::parse_scalar(dataset, scalar), values).of(items);
        double sum = 0;
        for (std::size_t i = 0; i < items.size(); ++i) sum += weights[i].second * of_items[i];
        out.values[scalar] = finite(sum);
    }
}

Probed probe_at(const store::Dataset& dataset, std::size_t step, const ciel::CellLocator& locator,
                const ciel::Vec3d& position) {
    Probed out;
    out.position = position;
    const ciel::Index cell = locator.cell_at(position);
    dataset.check_intact();
    if (cell == ciel::none) return out;
    const std::size_t mesh = dataset.steps()[step].mesh;
    out.cell = dataset.original_cell(mesh, cell);
    const ciel::Index vertex = locator.nearest_vertex(cell, position);
    out.vertex = dataset.original_vertex(mesh, vertex);
    out.solver_cell = dataset.solver_cell(mesh, cell);
    out.solver_vertex = dataset.solver_vertex(mesh, vertex);
    const ciel::VertexWeights weights = locator.weights_in(cell, position);
    const ciel::VertexWeights own{{cell, 1.0}};
    for (const store::ArrayInfo& array : dataset.info().arrays) {
        if (array.association == store::Association::boundary_face) continue;
        const bool on_points = array.association == store::Association::point;
        const bool is_wrong = on_points && went_wrong(dataset, step, array, cell);
        probe_array(dataset, step, array, on_points ? weights : own, is_wrong, out);
    }
    return out;
}

} // namespace

Probed probe(const store::Dataset& dataset, std::size_t step, const ciel::CellLocator& locator, ciel::Vec3d position) {
    return dataset.naming_changed_file([&] { return probe_at(dataset, step, locator, position); });
}

} // namespace server::probe
