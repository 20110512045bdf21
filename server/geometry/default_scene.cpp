#include "geometry/default_scene.hpp"

#include "annotations/camera.hpp"
#include "geometry/bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

namespace server::geometry {
namespace {

using nlohmann::json;

constexpr double default_aspect = 1.4; // width / height of the canvas beside the panels on a laptop, with a margin

struct Candidate {
    std::string scalar;
    std::size_t step = 0;
};

// Returns point scalars that vary, then magnitudes of vectors and tensors, each with the first step at which it varies.
std::vector<Candidate> candidates(const store::Dataset& dataset) {
    std::vector<Candidate> found;
    for (const store::ArrayInfo& array : dataset.info().arrays) {
        if (array.association != store::Association::point) continue;
        for (std::size_t step = 0; step < dataset.steps().size(); ++step) {
            const auto& arrays = dataset.steps()[step].arrays;
            const auto here = arrays.find(array.name);
            if (here == arrays.end() || !(here->second.range[0] < here->second.range[1])) continue;
            found.push_back({store::scalar_names(array).front(), step});
            break;
        }
    }
    std::stable_partition(found.begin(), found.end(),
                          [](const Candidate& c) { return c.scalar.find(':') == std::string::npos; });
    return found;
}

// Returns the share of blocks that the iso-surface of a typical value crosses. Returns 0 for a mesh with few blocks,
// because every surface crosses many of its blocks.
double crossed_share(const store::Dataset& dataset, const Candidate& of) {
    constexpr std::size_t fewest_blocks = 27;
    const auto ranges = dataset.block_ranges(store::parse_scalar(dataset, of.scalar), of.step);
    if (!ranges || ranges->low.size() < fewest_blocks) return 0;
    const std::size_t blocks = ranges->low.size();
    const auto median = [&](std::vector<double> ends) {
        std::ranges::nth_element(ends, ends.begin() + static_cast<std::ptrdiff_t>(blocks / 2));
        return ends[blocks / 2];
    };
    const double middle = (median(ranges->low) + median(ranges->high)) / 2;
    std::size_t crossed = 0;
    for (std::size_t block = 0; block < blocks; ++block)
        crossed += ranges->low[block] <= middle && middle < ranges->high[block] ? 1 : 0;
    return static_cast<double>(crossed) / static_cast<double>(blocks);
}

// Changes nothing unless the surface of the first scalar fills the mesh, as a surface of noise does.
void put_clear_surface_first(const store::Dataset& dataset, std::vector<Candidate>& scalars) {
    constexpr double many = 1.0 / 3;
    if (scalars.empty()) return;
    const double first = crossed_share(dataset, scalars.front());
    if (first <= many) return;
    const auto clear = std::ranges::find_if(scalars, [&](const Candidate& of) {
        const double share = crossed_share(dataset, of);
        return share > 0 && share <= first / 2;
    });
    if (clear != scalars.end()) std::rotate(scalars.begin(), clear, clear + 1);
}

bool is_written(const store::Dataset& dataset, const store::Step& step, const std::string& scalar) {
    return step.arrays.contains(store::parse_scalar(dataset, scalar).array);
}

// Reads about 100,000 values in runs spread over the array, so that few stretches (64 KiB) of the file are read.
std::vector<double> sample_of(const store::StoredScalar& values) {
    constexpr std::size_t runs = 256, run = 400;
    const std::size_t stride = std::max(values.size() / runs, run);
    std::vector<ciel::Index> items;
    for (std::size_t first = 0; first < values.size(); first += stride)
        for (std::size_t i = first; i < std::min(first + run, values.size()); ++i)
            items.push_back(static_cast<ciel::Index>(i));
    std::vector<double> sample;
    for (const double value : values.of(items))
        if (std::isfinite(value)) sample.push_back(value);
    return sample;
}

// Returns the middle between the 5th and 95th percentile, or of the whole range if the two percentiles are equal.
double sensible_value(store::LoadedDataset& loaded, const std::string& scalar, std::size_t step) {
    constexpr double few_bins = 8.0 / store::stored_bins;
    const store::Histogram histogram = loaded.histogram(scalar, step, store::stored_bins);
    const double low = histogram.quantile(0.05), high = histogram.quantile(0.95);
    if (high / 2 - low / 2 > few_bins * (histogram.range[1] / 2 - histogram.range[0] / 2)) return low / 2 + high / 2;

    // Outliers have made the bins too wide, so the percentiles of a sample are used.
    std::vector<double> sample = sample_of(*loaded.stored_scalar(scalar, step));
    if (sample.empty()) return 0;
    const auto at = [&](double share) {
        const auto place = sample.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sample.size() - 1));
        std::nth_element(sample.begin(), place, sample.end());
        return *place;
    };
    if (at(0.05) < at(0.95)) return at(0.05) / 2 + at(0.95) / 2;
    return at(0) / 2 + at(1) / 2;
}

// `thin`: if set, the camera looks exactly along this axis, as in a plan drawing.
json camera_of(const BoundingBox& box, std::optional<std::size_t> thin) {
    annotations::ViewCamera camera = annotations::default_camera(box.low, box.high, default_aspect);
    if (thin) {
        const ciel::Vec3d& target = camera.target;
        const double distance =
            std::hypot(camera.position[0] - target[0], camera.position[1] - target[1], camera.position[2] - target[2]);
        camera.position = target;
        camera.position[*thin] += *thin == 1 ? -distance : distance;
        camera.up = *thin == 2 ? ciel::Vec3d{0, 1, 0} : ciel::Vec3d{0, 0, 1};
    }
    return {{"position", camera.position}, {"target", camera.target}, {"up", camera.up}, {"fov", camera.fov_degrees}};
}

BoundingBox domain_of(const store::Dataset& dataset, const store::Step& step) {
    const auto& b = dataset.info().meshes[step.mesh].bounds;
    return {{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
}

// Also checks the cell array from which a point array was made: a cell that is not finite may have finite corners.
bool is_finite(const store::Step& step, const std::string& array) {
    const auto written = step.arrays.find(array);
    if (written == step.arrays.end() || written->second.invalid > 0) return false;
    const auto cells = step.arrays.find("cell:" + array);
    if (cells != step.arrays.end() && cells->second.invalid > 0) return false;
    return !written->second.late && std::isfinite(written->second.range[0]) && std::isfinite(written->second.range[1]);
}

// Returns the last step with the most finite arrays (before a divergence). REQUIRES: at least one step.
std::size_t last_whole_step(const store::Dataset& dataset) {
    std::size_t last = 0;
    std::ptrdiff_t most = -1;
    for (std::size_t i = 0; i < dataset.steps().size(); ++i) {
        const auto finite = std::ranges::count_if(dataset.info().arrays, [&](const store::ArrayInfo& array) {
            return array.association == store::Association::point && is_finite(dataset.steps()[i], array.name);
        });
        if (finite < most) continue;
        most = finite;
        last = i;
    }
    return last;
}

bool has_name(const store::ArrayInfo& array, std::span<const std::string_view> names) {
    return std::ranges::any_of(names, [&](std::string_view name) {
        return std::ranges::equal(array.name, name, {}, [](char c) { return 'A' <= c && c <= 'Z' ? c + 32 : int{c}; });
    });
}

// Returns the first array that varies and has one of the names (in lower case), else the first that varies, or null.
const store::ArrayInfo* preferred(const store::Dataset& dataset, const store::Step& step, int components,
                                  std::span<const std::string_view> names) {
    const store::ArrayInfo* first = nullptr;
    for (const store::ArrayInfo& array : dataset.info().arrays) {
        if (array.association != store::Association::point || array.components != components) continue;
        const auto written = step.arrays.find(array.name);
        if (written == step.arrays.end() || !(written->second.range[0] < written->second.range[1])) continue;
        if (has_name(array, names)) return &array;
        if (first == nullptr) first = &array;
    }
    return first;
}

// Returns the slice's normal. Prefers an axis along which the bodies span the domain, as wings between walls do.
std::size_t axis_of_slice(const BoundingBox& bodies, const BoundingBox& domain) {
    constexpr double whole = 0.98, as_thin = 1.01;
    const auto length = [](const BoundingBox& box, std::size_t axis) { return box.high[axis] - box.low[axis]; };
    std::size_t axis = 1; // a slice perpendicular to y faces the default camera
    for (const std::size_t other : {0U, 2U})
        if (as_thin * length(bodies, other) < length(bodies, axis)) axis = other;
    for (const std::size_t other : {0U, 1U, 2U})
        if (length(bodies, other) > whole * length(domain, other)) axis = other;
    return axis;
}

// If a patch has the type empty or wedge, the mesh has only one layer of cells along its thinnest axis.
std::optional<std::size_t> thin_axis(std::span<const MeasuredPatch> patches, const BoundingBox& domain) {
    if (std::ranges::none_of(patches,
                             [](const MeasuredPatch& patch) { return patch.type == "empty" || patch.type == "wedge"; }))
        return std::nullopt;
    std::size_t thinnest = 0;
    for (const std::size_t axis : {1U, 2U})
        if (domain.high[axis] - domain.low[axis] < domain.high[thinnest] - domain.low[thinnest]) thinnest = axis;
    return thinnest;
}

json color_by(const store::ArrayInfo* array) {
    if (array == nullptr) return json::object();
    return {{"array", store::scalar_names(*array).front()}};
}

json slice_across(std::size_t axis, const BoundingBox& box, const store::ArrayInfo* array) {
    return {{"type", "slice"},
            {"order", 2},
            {"axis", std::string(1, static_cast<char>('x' + axis))},
            {"value", (box.low[axis] + box.high[axis]) / 2},
            {"color", color_by(array)}};
}

constexpr std::array<std::string_view, 6> pressures{"p",     "pressure", "staticpressure", "static_pressure",
                                                    "p_rgh", "pmean"};
constexpr std::array<std::string_view, 6> velocities{"u", "velocity", "v", "vel", "umean", "ux"};

// `thin`: if the mesh has one layer of cells, the axis perpendicular to the layer.
void show_bodies(const store::Dataset& dataset, const store::Step& step, std::span<const MeasuredPatch> bodies,
                 std::optional<std::size_t> thin, json& scene) {
    const store::ArrayInfo* scalar = preferred(dataset, step, 1, pressures);
    const store::ArrayInfo* vector = preferred(dataset, step, 3, velocities);
    json names = json::array();
    for (const MeasuredPatch& body : bodies) names.push_back(body.name);
    json& layers = scene["layers"];
    layers["surface"] = {{"type", "surface"},
                         {"order", 1},
                         {"groups", std::move(names)},
                         {"color", color_by(scalar != nullptr ? scalar : vector)}};
    if (scalar == nullptr && vector == nullptr) return;
    const BoundingBox box = box_around(bodies);
    const std::size_t axis = thin.value_or(axis_of_slice(box, domain_of(dataset, step)));
    layers["slice"] = slice_across(axis, box, vector != nullptr ? vector : scalar);
}

void show_layer(const store::Dataset& dataset, const store::Step& step, std::size_t axis, json& scene) {
    const store::ArrayInfo* vector = preferred(dataset, step, 3, velocities);
    const store::ArrayInfo* scalar = preferred(dataset, step, 1, pressures);
    scene["layers"]["slice"] = slice_across(axis, domain_of(dataset, step), vector != nullptr ? vector : scalar);
}

void show_iso_surface(store::LoadedDataset& loaded, const std::vector<Candidate>& scalars, json& scene) {
    const auto dataset = loaded.dataset();
    json& layers = scene["layers"];
    if (scalars.empty()) {
        layers["surface"] = {{"type", "surface"}, {"order", 1}, {"groups", json::array()}};
        return;
    }
    const auto& [scalar, step_index] = scalars.front();
    json color = json::object();
    for (const Candidate& other : scalars)
        if (other.scalar != scalar && is_written(*dataset, dataset->steps()[step_index], other.scalar))
            color["array"] = other.scalar;
    layers["iso"] = {{"type", "iso"},
                     {"order", 2},
                     {"array", scalar},
                     {"values", {sensible_value(loaded, scalar, step_index)}},
                     {"color", std::move(color)}};
}

} // namespace

DefaultScene default_scene(store::LoadedDataset& loaded, const std::string& name) {
    const auto dataset = loaded.dataset();
    DefaultScene shown;
    json& scene = shown.document = {{"dataset", name}};
    scene["layers"]["outline"] = {{"type", "outline"}, {"order", 0}};
    if (dataset->steps().empty()) return shown;

    const std::size_t last = last_whole_step(*dataset);
    const store::Step& at_end = dataset->steps()[last];
    const auto patches = patches_of(*dataset, at_end);
    const auto bodies = bodies_of(patches, domain_of(*dataset, at_end));
    auto scalars = candidates(*dataset);
    put_clear_surface_first(*dataset, scalars);
    const auto thin = thin_axis(patches, domain_of(*dataset, at_end));
    const store::Step& step =
        !bodies.empty() || thin ? at_end : dataset->steps()[scalars.empty() ? 0 : scalars.front().step];
    if (!bodies.empty())
        show_bodies(*dataset, step, bodies, thin, scene);
    else if (thin && !scalars.empty())
        show_layer(*dataset, step, *thin, scene);
    else
        show_iso_surface(loaded, scalars, scene);
    shown.box = bodies.empty() ? domain_of(*dataset, step) : box_around(bodies);
    scene["time"] = step.time;
    scene["camera"] = camera_of(shown.box, thin);
    return shown;
}

} // namespace server::geometry
