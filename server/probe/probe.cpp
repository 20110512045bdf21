#include "probe/probe.hpp"

#include "store/no_value.hpp"

#include <algorithm>
#include <cmath>

namespace ciel::probe {
namespace {

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

double scalar_at(ValuesView values, const store::ArrayInfo& array, Index item, const store::ScalarName& name) {
    const auto width = static_cast<std::size_t>(array.components);
    return store::scalar_of(array, values.subview(width * item, width), name);
}

// True if the cell blew up. Its corners have the values of its neighbours and do not show that.
bool went_wrong(const store::Dataset& dataset, std::size_t step, const store::ArrayInfo& array, Index cell) {
    const std::string of_cells = store::cell_scalar(dataset, store::scalar_names(array).front());
    if (of_cells.empty()) return false;
    const auto values = dataset.values(store::parse_scalar(dataset, of_cells).array, step);
    const auto width = static_cast<std::size_t>(array.components);
    return !values.empty() && std::ranges::any_of(values.subview(width * cell, width), store::went_wrong);
}

// The weighted sum of the values of vertices, or of one cell.
void probe_array(const store::Dataset& dataset, std::size_t step, const store::ArrayInfo& array,
                 const VertexWeights& weights, bool is_wrong, Probed& out) {
    const auto values = dataset.values(array.name, step);
    for (const std::string& scalar : store::scalar_names(array)) {
        out.values[scalar] = std::nullopt;
        if (values.empty() || is_wrong) continue;
        const store::ScalarName name = store::parse_scalar(dataset, scalar);
        double sum = 0;
        for (const auto& [item, share] : weights) sum += share * scalar_at(values, array, item, name);
        out.values[scalar] = finite(sum);
    }
}

} // namespace

Probed probe(const store::Dataset& dataset, std::size_t step, const CellLocator& locator, Vec3d position) {
    Probed out;
    out.position = position;
    const Index cell = locator.cell_at(position);
    if (cell == none) return out;
    const std::size_t mesh = dataset.steps()[step].mesh;
    out.cell = dataset.original_cell(mesh)[cell];
    const Index vertex = locator.nearest_vertex(cell, position);
    out.vertex = dataset.original_vertex(mesh)[vertex];
    if (const auto ids = dataset.solver_cell(mesh); !ids.empty() && ids[cell] >= 0) out.solver_cell = ids[cell];
    if (const auto ids = dataset.solver_vertex(mesh); !ids.empty() && ids[vertex] >= 0) out.solver_vertex = ids[vertex];
    const VertexWeights weights = locator.weights_in(cell, position);
    const VertexWeights own{{cell, 1.0}};
    for (const store::ArrayInfo& array : dataset.info().arrays) {
        if (array.association == store::Association::boundary_face) continue;
        const bool on_points = array.association == store::Association::point;
        const bool is_wrong = on_points && went_wrong(dataset, step, array, cell);
        probe_array(dataset, step, array, on_points ? weights : own, is_wrong, out);
    }
    return out;
}

} // namespace ciel::probe
