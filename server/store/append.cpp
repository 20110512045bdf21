#include "store/append.hpp"

#include "ciel/mesh_faces.hpp"
#include "ciel/point_interpolation.hpp"
#include "store/format/attributes.hpp"
#include "store/mesh_arrays.hpp"
#include "store/writer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace server::store {
namespace {

constexpr std::string_view cell_prefix = "cell:";
constexpr std::size_t longest_name = 200;

bool has(const std::vector<ArrayInfo>& arrays, const std::string& name) {
    return std::ranges::any_of(arrays, [&](const ArrayInfo& array) { return array.name == name; });
}

// Throws Error if a new array must not have this name. Arrays are never deleted, so a bad name would stay forever.
void check_new_name(const std::string& name) {
    const std::string plain = name.starts_with(cell_prefix) ? name.substr(cell_prefix.size()) : name;
    const auto is_bad = [](unsigned char c) { return c < ' ' || c == 0x7f || c == '/' || c == '\\' || c == ':'; };
    std::string problem;
    if (plain.empty() || plain.front() == ' ' || plain.back() == ' ')
        problem = "is empty or begins or ends with a space";
    else if (plain == "." || plain == "..")
        problem = "is . or ..";
    else if (plain.size() > longest_name)
        problem = "is longer than " + std::to_string(longest_name) + " bytes";
    else if (std::ranges::any_of(plain, is_bad))
        problem = "holds a '/', '\\', ':' or control character (the only allowed prefix is 'cell:')";
    if (!problem.empty())
        throw ciel::Error("array '" + name + "' is not in the dataset, and a new array cannot have a name that " +
                          problem);
}

ArrayInfo describe(const Dataset& dataset, const WantedArray& wanted) {
    const ArrayInfo* known = dataset.find(wanted.name);
    if (known == nullptr) check_new_name(wanted.name);
    const auto usual = known == nullptr ? std::size_t{1} : static_cast<std::size_t>(known->components);
    const std::size_t components = wanted.components.value_or(usual);
    if (known != nullptr && components != usual)
        throw ciel::Error("array '" + wanted.name + "' has " + std::to_string(usual) +
                          " components in the dataset, but the values have " + std::to_string(components));
    if (components < 1 || components > most_components)
        throw ciel::Error("array '" + wanted.name + "' must have 1 to " + std::to_string(most_components) +
                          " components");
    if (known != nullptr && known->association == Association::boundary_face)
        throw ciel::Error("array '" + wanted.name +
                          "' has values on the faces of patches, which only an import can write; leave the array out");
    if (known != nullptr) return *known;
    ArrayInfo added;
    added.name = wanted.name;
    added.association = wanted.name.starts_with(cell_prefix) ? Association::cell : Association::point;
    added.components = static_cast<int>(components);
    added.doubles = wanted.doubles;
    return added;
}

std::span<const ciel::Index> original_ids(const Dataset& dataset, std::size_t mesh, Association association) {
    return association == Association::point ? dataset.original_vertex(mesh) : dataset.original_cell(mesh);
}

PlannedArray plan_array(const Dataset& dataset, std::size_t mesh, const WantedArray& wanted) {
    PlannedArray planned{describe(dataset, wanted), 0, wanted.doubles, std::nullopt};
    const bool on_points = planned.info.association == Association::point;
    planned.tuples = on_points ? dataset.info().input_vertices : dataset.info().input_cells;
    const auto ids = original_ids(dataset, mesh, planned.info.association);
    if (*std::ranges::max_element(ids) >= planned.tuples)
        throw ciel::Error("the last step of " + dataset.info().name +
                          " is on another mesh than the imported file, so the order of the values of '" + wanted.name +
                          "' is unknown; append a dataset on the mesh of that step with `ciel append --from`");
    return planned;
}

// Returns the point array that an import would interpolate from `cells`; nullopt if there is none.
std::optional<ArrayInfo> made_from(const Dataset& dataset, const StepPlan& plan, const ArrayInfo& cells) {
    if (cells.association != Association::cell || !cells.name.starts_with(cell_prefix)) return std::nullopt;
    ArrayInfo made = cells;
    made.name = cells.name.substr(cell_prefix.size());
    made.association = Association::point;
    made.source.origin = Origin::interpolated;
    if (std::ranges::any_of(plan.arrays, [&](const auto& array) { return array.info.name == made.name; }))
        return std::nullopt;
    const ArrayInfo* known = dataset.find(made.name);
    if (known == nullptr) return dataset.find(cells.name) == nullptr ? std::optional(made) : std::nullopt;
    const bool is_the_same = known->association == made.association && known->components == made.components;
    return is_the_same ? std::optional(*known) : std::nullopt;
}

std::uint64_t stored_bytes(const Dataset& dataset, std::size_t mesh, const ArrayInfo& array) {
    return original_ids(dataset, mesh, array.association).size() * static_cast<std::uint64_t>(array.components) *
           array.value_bytes();
}

void check_time(const Dataset& dataset, double time) {
    if (!std::isfinite(time)) throw ciel::Error("the time of a step must be a finite number");
    if (dataset.steps().empty() || time > dataset.steps().back().time) return;
    std::ostringstream sentence;
    sentence << "time " << time << " is not later than the last step of " << dataset.info().name
             << ", which is at time " << dataset.steps().back().time;
    throw ciel::Error(sentence.str());
}

Values to_stored_order(ciel::ValuesView values, std::span<const ciel::Index> original, std::size_t components) {
    return values.with([&]<class T>(std::span<const T> all) {
        std::vector<T> stored(original.size() * components);
        for (std::size_t i = 0; i < original.size(); ++i) {
            // Reads the id only once: `original` is a mapped file that can change between the check and the use.
            const std::size_t from = original[i] * components;
            if (from >= all.size()) throw ciel::Error("the dataset's original ids are damaged; import the data again");
            std::copy_n(&all[from], components, &stored[i * components]);
        }
        return Values(std::move(stored));
    });
}

ciel::FaceMeshView loaded_boundary(const Dataset& dataset, std::size_t mesh, std::size_t coordinates) {
    ciel::FaceMeshView boundary = dataset.mesh_arrays().boundary(mesh, coordinates);
    if (boundary.loader != nullptr) boundary.loader->load(0, boundary.vertex_count());
    return boundary;
}

void write_arrays(Writer& writer, const StepPlan& plan, const ValuesOf& values_of) {
    const Dataset& dataset = *writer.before();
    std::optional<ciel::PointInterpolation> points; // made once and used for all arrays of the step
    for (std::size_t i = 0; i < plan.arrays.size(); ++i) {
        const PlannedArray& array = plan.arrays[i];
        const auto values = values_of(i);
        if (values.size() != array.values())
            throw ciel::Error("array '" + array.info.name + "' has " + std::to_string(values.size()) +
                              " values, but must have " + std::to_string(array.tuples) + " x " +
                              std::to_string(array.info.components) + ", one for each point or cell and component");
        const auto ids = original_ids(dataset, plan.mesh, array.info.association);
        const Values stored = to_stored_order(values, ids, static_cast<std::size_t>(array.info.components));
        writer.add_values({array.info, stored});
        if (!array.made) continue;
        if (!points) points.emplace(dataset.topology(plan.mesh), loaded_boundary(dataset, plan.mesh, plan.coordinates));
        const int components = array.made->components;
        stored.with([&](auto cells) { writer.add_values({*array.made, points->apply(cells, components)}); });
    }
    dataset.check_intact();
}

// Also compares the order of the faces, because arrays on boundary faces have this order.
bool same_faces(const ciel::FaceMeshView& a, const ciel::FaceMeshView& b) {
    bool same = std::ranges::equal(a.owner, b.owner);
    for (ciel::Index face = 0; same && face < a.face_count(); ++face)
        same = std::ranges::equal(a.loop(face), b.loop(face));
    return same;
}

std::size_t mesh_like(const Dataset& dataset, const Dataset& source, std::size_t of_source) {
    const ciel::Topology wanted = source.topology(of_source);
    const ciel::FaceMeshView boundary = source.mesh_arrays().boundary(of_source, 0);
    for (std::size_t mesh = 0; mesh < dataset.info().meshes.size(); ++mesh)
        if (same_faces(dataset.mesh_arrays().boundary(mesh, 0), boundary) &&
            ciel::same_cells(dataset.topology(mesh), wanted))
            return mesh;
    throw ciel::Error(source.directory().string() + ": is on another mesh than " + dataset.info().name +
                      "; only steps on the same mesh can be appended");
}

// Returns the index of the mesh's coordinate set with the positions of `wanted`. If there is none, adds the set.
std::size_t coordinates_like(Writer& writer, std::size_t mesh, const ciel::FaceMeshView& wanted) {
    const ciel::FaceMeshView known = writer.before()->mesh_arrays().points(mesh, 0);
    Values positions(wanted.positions, wanted.keep_alive);
    // In a dataset of an earlier version, the origin can be different from zero.
    if (known.origin != wanted.origin) {
        std::vector<double> moved(wanted.positions.begin(), wanted.positions.end());
        for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += wanted.origin[i % 3] - known.origin[i % 3];
        positions = converted(moved, known.positions.has_doubles());
    }
    if (const auto found = writer.find_coordinates(mesh, positions)) return *found;
    return writer.add_coordinates(mesh, positions);
}

} // namespace

StepPlan plan_step(const Dataset& dataset, double time, std::span<const WantedArray> wanted) {
    check_time(dataset, time);
    StepPlan plan;
    plan.time = time;
    if (!dataset.steps().empty()) {
        plan.mesh = dataset.steps().back().mesh;
        plan.coordinates = dataset.steps().back().coordinates;
    }
    std::set<std::string> names;
    for (const WantedArray& each : wanted) {
        if (!names.insert(each.name).second)
            throw ciel::Error("array '" + each.name + "' is given twice; give it once");
        plan.arrays.push_back(plan_array(dataset, plan.mesh, each));
    }
    std::vector<ArrayInfo> written;
    for (PlannedArray& array : plan.arrays) {
        array.made = made_from(dataset, plan, array.info);
        written.push_back(array.info);
        if (array.doubles && !array.info.doubles) plan.rounded.push_back(array.info.name);
        if (array.made) written.push_back(*array.made);
    }
    for (const ArrayInfo& array : written) {
        plan.stored_bytes += stored_bytes(dataset, plan.mesh, array);
        if (dataset.find(array.name) == nullptr) plan.added.push_back(array.name);
    }
    for (const ArrayInfo& known : dataset.info().arrays)
        if (!has(written, known.name)) plan.lacking.push_back(known.name);
    return plan;
}

AppendedStep append_step(const std::shared_ptr<Dataset>& dataset, double time, std::span<const WantedArray> wanted,
                         const ValuesOf& values_of) {
    Writer writer = Writer::append(dataset);
    AppendedStep done{writer.before()->steps().size(), plan_step(*writer.before(), time, wanted)};
    writer.begin_step(time, done.plan.mesh, done.plan.coordinates);
    write_arrays(writer, done.plan, values_of);
    writer.end_step();
    writer.finish();
    return done;
}

std::size_t append_dataset(const std::shared_ptr<Dataset>& dataset, const Dataset& source) {
    Writer writer = Writer::append(dataset);
    const Dataset& target = *writer.before();
    std::map<std::size_t, std::size_t> mesh_of; // index of a mesh in `source` -> its index in `dataset`
    std::size_t appended = 0;
    for (std::size_t step = 0; step < source.steps().size(); ++step) {
        const Step& at = source.steps()[step];
        if (!target.steps().empty() && at.time <= target.steps().back().time) continue;
        auto known = mesh_of.find(at.mesh);
        if (known == mesh_of.end()) known = mesh_of.emplace(at.mesh, mesh_like(target, source, at.mesh)).first;
        const std::size_t mesh = known->second;
        std::vector<Values> held;
        std::vector<ArrayValues> arrays;
        for (const auto& [name, array] : at.arrays) {
            held.push_back(source.values(name, step));
            arrays.push_back({*source.find(name), held.back()});
        }
        writer.add_step(at.time, mesh,
                        coordinates_like(writer, mesh, source.mesh_arrays().points(at.mesh, at.coordinates)), arrays);
        ++appended;
    }
    writer.finish();
    if (appended == 0)
        throw ciel::Error(source.directory().string() + ": has no step later than the last step of " +
                          dataset->directory().string());
    return appended;
}

} // namespace server::store
