#include "session/probe.hpp"

#include <cmath>

namespace ciel::session {
namespace {

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

double component_of(std::span<const float> values, int components, Index id, const store::ScalarName& name) {
    const float* item = &values[static_cast<std::size_t>(components) * id];
    if (name.component) return item[*name.component];
    if (!name.magnitude) return item[0];
    double squares = 0;
    for (int i = 0; i < components; ++i) squares += static_cast<double>(item[i]) * item[i];
    return std::sqrt(squares);
}

// The weighted sum of the values of vertices, or of one cell.
void probe_array(const store::Dataset& dataset, std::size_t step, const store::ArrayInfo& array, const Weights& weights,
                 Probed& out) {
    const auto values = dataset.values(array.name, step);
    for (const std::string& scalar : store::scalar_names(array)) {
        out.values[scalar] = std::nullopt;
        if (values.empty()) continue;
        const store::ScalarName name = store::parse_scalar(dataset, scalar);
        double sum = 0;
        for (const auto& [item, share] : weights) sum += share * component_of(values, array.components, item, name);
        out.values[scalar] = finite(sum);
    }
}

} // namespace

Probed probe(const store::Dataset& dataset, std::size_t step, const Locator& locator, Vec3d position) {
    Probed out;
    out.position = position;
    const Index cell = locator.cell_at(position);
    if (cell == none) return out;
    const std::size_t mesh = dataset.steps()[step].mesh;
    out.cell = dataset.original_cell(mesh)[cell];
    out.vertex = dataset.original_vertex(mesh)[locator.nearest_vertex(cell, position)];
    const Weights weights = locator.weights_in(cell, position);
    const Weights own{{cell, 1.0}};
    for (const store::ArrayInfo& array : dataset.info().arrays)
        probe_array(dataset, step, array, array.association == store::Association::point ? weights : own, out);
    return out;
}

std::optional<Vec3d> position_under(const Geometry& geometry, const scene::Scene& scene, ViewSize size,
                                    std::array<double, 2> pixel, const Locator& locator, Worker& worker,
                                    std::function<void()> check_wanted) {
    const auto width = static_cast<int>(size.width), height = static_cast<int>(size.height);
    if (!(pixel[0] >= 0 && pixel[0] < width && pixel[1] >= 0 && pixel[1] < height)) return {};
    render::Image image;
    render::Frame frame = frame_of(geometry, scene, width, height, 1);
    frame.check_wanted = std::move(check_wanted);
    worker.renderer().draw(frame, image);
    Vec3d hit{};
    if (!worker.renderer().pick(static_cast<int>(pixel[0]), static_cast<int>(pixel[1]), hit)) return {};
    if (locator.cell_at(hit) != none) return hit;

    const render::Camera& camera = frame.camera;
    const auto& from = camera.parallel ? camera.target : hit;
    Vec3d sight{}, diagonal{};
    double sight_length = 0, size_of_all = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        sight[axis] = from[axis] - camera.position[axis];
        diagonal[axis] = geometry.bounds_max[axis] - geometry.bounds_min[axis];
        sight_length += sight[axis] * sight[axis];
        size_of_all += diagonal[axis] * diagonal[axis];
    }
    for (const double share : {1e-5, -1e-5, 1e-4, -1e-4, 1e-3, -1e-3}) {
        Vec3d moved = hit;
        for (std::size_t axis = 0; axis < 3; ++axis)
            moved[axis] += sight[axis] / std::sqrt(sight_length) * share * std::sqrt(size_of_all);
        if (locator.cell_at(moved) != none) return moved;
    }
    return hit;
}

} // namespace ciel::session
