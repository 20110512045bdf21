#include "bench/case.hpp"
#include "store/mesh_arrays.hpp"

#include <limits>

namespace server::bench {

namespace {

constexpr std::size_t no_budget = std::numeric_limits<std::size_t>::max();

bool varies(const store::Step& step, const std::string& array) {
    const auto found = step.arrays.find(array);
    return found != step.arrays.end() && found->second.range[0] < found->second.range[1];
}

std::string first_that_varies(const store::Dataset& dataset) {
    for (const store::ArrayInfo& array : dataset.info().arrays)
        for (const store::Step& step : dataset.steps())
            if (array.association == store::Association::point && varies(step, array.name)) return array.name;
    throw ciel::Error("dataset '" + dataset.info().name +
                      "' has no array on points whose values differ, so no surface can be cut; choose another dataset");
}

// Returns the last two steps at which the array varies, the later step first. Throws Error when there is no such step.
std::vector<std::size_t> steps_with(const store::Dataset& dataset, const std::string& array) {
    std::vector<std::size_t> found;
    for (std::size_t step = dataset.steps().size(); step-- > 0 && found.size() < 2;)
        if (varies(dataset.steps()[step], array)) found.push_back(step);
    if (found.empty())
        throw ciel::Error("array '" + array +
                          "' has the same value everywhere, so no surface can be cut; choose another array");
    return found;
}

store::Values grown(const store::Values& values) {
    return values.with([]<class T>(std::span<const T> all) {
        std::vector<T> changed(all.begin(), all.end());
        for (T& value : changed) value *= static_cast<T>(1.01);
        return store::Values(std::move(changed));
    });
}

} // namespace

Case open_case(const std::string& path, const std::string& array) {
    Case data;
    data.path = path;
    data.dataset = store::Dataset::open(path);
    data.array = array.empty() ? first_that_varies(*data.dataset) : array;
    data.loaded = std::make_shared<store::LoadedDataset>(data.dataset, no_budget);
    store::LoadedDataset& loaded = *data.loaded;
    const std::vector<std::size_t> steps =
        steps_with(*data.dataset, store::parse_scalar(*data.dataset, data.array).array);
    const store::Step& step = data.dataset->steps()[steps[0]];
    data.time = step.time;
    data.mesh = data.dataset->mesh_arrays().all_faces(step.mesh, step.coordinates);
    data.values = loaded.scalar_values(data.array, steps[0]);
    const bool same_mesh = steps.size() > 1 && data.dataset->steps()[steps[1]].mesh == step.mesh;
    data.changed = same_mesh ? loaded.scalar_values(data.array, steps[1]) : grown(data.values);
    data.topology = loaded.topology(step.mesh);
    data.cell_fits = std::make_shared<ciel::CellFits>(*data.topology);
    return data;
}

std::uint64_t triangles_of(const ciel::Surface& surface) {
    return surface.polygon_vertex.size() - 2 * surface.polygon_cell.size();
}

std::vector<double> values_between(double low, double high, std::size_t count) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
        values[i] = low + (high - low) * static_cast<double>(i + 1) / static_cast<double>(count + 1);
    return values;
}

ciel::Field field_of(const Case& data, const store::Values& values) {
    ciel::Field field(*data.topology, values, values.keep_alive());
    field.set_cell_fits(data.cell_fits);
    return field;
}

} // namespace server::bench
