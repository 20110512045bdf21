#include "session/default_scene.hpp"

#include "render/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ciel::session {
namespace {

using nlohmann::json;

constexpr double default_aspect = 1.4; // a laptop's canvas beside its panels, with room to spare
constexpr std::size_t sample_size = 100'000;

struct Candidate {
    std::string scalar;
    std::size_t step = 0;
};

// One scalar per point array that varies, at its first step that varies: vectors by their magnitude.
std::vector<Candidate> candidates(const store::Dataset& dataset) {
    std::vector<Candidate> found;
    for (const store::ArrayInfo& array : dataset.info().arrays) {
        if (array.association != store::Association::point) continue;
        for (std::size_t step = 0; step < dataset.steps().size(); ++step) {
            const auto& arrays = dataset.steps()[step].arrays;
            const auto here = arrays.find(array.name);
            if (here == arrays.end() || !(here->second.range[0] < here->second.range[1])) continue;
            found.push_back({array.components == 1 ? array.name : array.name + ":magnitude", step});
            break;
        }
    }
    // Scalars before vectors, each in the dataset's order.
    std::stable_partition(found.begin(), found.end(),
                          [](const Candidate& c) { return c.scalar.find(':') == std::string::npos; });
    return found;
}

bool is_written(const store::Dataset& dataset, const store::Step& step, const std::string& scalar) {
    return step.arrays.contains(store::parse_scalar(dataset, scalar).array);
}

double sensible_value(const std::vector<float>& values) {
    std::vector<float> sample;
    const std::size_t stride = values.size() / sample_size + 1;
    for (std::size_t i = 0; i < values.size(); i += stride)
        if (std::isfinite(values[i])) sample.push_back(values[i]);
    if (sample.empty()) return 0;
    const auto at = [&](double share) {
        const auto place = sample.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sample.size() - 1));
        std::nth_element(sample.begin(), place, sample.end());
        return static_cast<double>(*place);
    };
    if (at(0.05) < at(0.95)) return (at(0.05) + at(0.95)) / 2;
    return (at(0) + at(1)) / 2;
}

// A patch inside the domain along two axes at least is a body in the flow; the others are its outer sides.
bool is_obstacle(const store::Group& group, const FaceMeshView& mesh, const store::MeshInfo& info) {
    std::array<double, 6> box{INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (const Index face : group.ids)
        for (const Index vertex : mesh.loop(face))
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double at = mesh.origin[axis] + mesh.positions[std::size_t{3} * vertex + axis];
                box[2 * axis] = std::min(box[2 * axis], at);
                box[2 * axis + 1] = std::max(box[2 * axis + 1], at);
            }
    int inside = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double margin = 0.01 * (info.bounds[2 * axis + 1] - info.bounds[2 * axis]);
        inside +=
            box[2 * axis] > info.bounds[2 * axis] + margin && box[2 * axis + 1] < info.bounds[2 * axis + 1] - margin;
    }
    return inside >= 2;
}

json camera_of(const store::MeshInfo& mesh) {
    const auto& b = mesh.bounds;
    const render::Camera camera = render::default_camera({b[0], b[2], b[4]}, {b[1], b[3], b[5]}, default_aspect);
    return {{"position", camera.position}, {"target", camera.target}, {"up", camera.up}, {"fov", camera.fov_degrees}};
}

json obstacles(const store::Dataset& dataset, const store::Step& step) {
    json names = json::array();
    const FaceMeshView mesh = dataset.mesh(step.mesh, step.coordinates);
    for (const store::Group& group : dataset.groups(step.mesh))
        if (group.of == store::Group::Of::faces && !group.ids.empty() &&
            is_obstacle(group, mesh, dataset.info().meshes[step.mesh]))
            names.push_back(group.name);
    return names;
}

} // namespace

json default_scene(store::LoadedDataset& loaded, const std::string& name) {
    const auto dataset = loaded.dataset();
    json scene{{"dataset", name}};
    json& layers = scene["layers"] = json::object();
    layers["outline"] = {{"type", "outline"}, {"order", 0}};
    if (dataset->steps().empty()) return scene;

    const auto scalars = candidates(*dataset);
    const std::size_t step_index = scalars.empty() ? 0 : scalars.front().step;
    const store::Step& step = dataset->steps()[step_index];
    scene["time"] = step.time;
    scene["camera"] = camera_of(dataset->info().meshes[step.mesh]);
    json bodies = obstacles(*dataset, step);
    if (scalars.empty() || !bodies.empty())
        layers["surface"] = {{"type", "surface"}, {"order", 1}, {"groups", std::move(bodies)}};
    if (scalars.empty()) return scene;

    const std::string& scalar = scalars.front().scalar;
    json color = json::object();
    for (const Candidate& other : scalars)
        if (other.scalar != scalar && is_written(*dataset, step, other.scalar)) color["array"] = other.scalar;
    layers["iso"] = {{"type", "iso"},
                     {"order", 2},
                     {"array", scalar},
                     {"values", {sensible_value(*loaded.scalar_values(scalar, step_index))}},
                     {"color", std::move(color)}};
    return scene;
}

} // namespace ciel::session
