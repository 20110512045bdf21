// ciel append: adds time steps to a dataset, also while it is served.
#include "app/commands.hpp"
#include "store/npy.hpp"
#include "store/writer.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

namespace ciel::app {
namespace {

using store::ArrayValues;
using store::Association;
using store::Dataset;

constexpr std::string_view cell_prefix = "cell:";
constexpr std::size_t longest_name = 200;

struct Options {
    std::string dataset, from;
    std::optional<double> time;
    std::vector<std::string> arrays; // NAME=FILE.npy
};

template <typename T>
bool equal(std::span<const T> a, std::span<const T> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

bool same_topology(const FaceMeshView& a, const FaceMeshView& b) {
    return equal(a.cell_types, b.cell_types) && equal(a.face_offset, b.face_offset) &&
           equal(a.face_vertex, b.face_vertex) && equal(a.owner, b.owner) && equal(a.neighbour, b.neighbour) &&
           a.vertex_count() == b.vertex_count();
}

std::size_t mesh_like(const Dataset& dataset, const FaceMeshView& wanted, const std::string& from) {
    for (std::size_t mesh = 0; mesh < dataset.info().meshes.size(); ++mesh)
        if (same_topology(dataset.mesh(mesh, 0), wanted)) return mesh;
    throw Error(from + ": is on another mesh than " + dataset.info().name +
                "; only steps on the same mesh can be appended");
}

// The set of positions that a step of the other dataset stands on, offset to the origin of ours; added when it is new.
std::size_t coordinates_like(const Dataset& dataset, store::Writer& writer, std::size_t mesh,
                             const FaceMeshView& wanted) {
    const FaceMeshView first = dataset.mesh(mesh, 0);
    if (first.origin == wanted.origin && equal(first.positions, wanted.positions)) return 0;
    std::vector<float> positions(wanted.positions.begin(), wanted.positions.end());
    for (std::size_t i = 0; i < positions.size(); ++i)
        positions[i] = static_cast<float>(wanted.origin[i % 3] - first.origin[i % 3] + double{positions[i]});
    return writer.add_coordinates(mesh, positions);
}

int append_dataset(const Options& options) {
    const auto source = Dataset::open(options.from), target = Dataset::open(options.dataset);
    store::Writer writer = store::Writer::append(options.dataset);
    std::size_t appended = 0;
    for (std::size_t step = 0; step < source->steps().size(); ++step) {
        const store::Step& at = source->steps()[step];
        if (!target->steps().empty() && at.time <= target->steps().back().time) continue;
        const FaceMeshView view = source->mesh(at.mesh, at.coordinates);
        const std::size_t mesh = mesh_like(*target, view, options.from);
        std::vector<ArrayValues> arrays;
        for (const auto& [name, array] : at.arrays) arrays.push_back({*source->find(name), source->values(name, step)});
        writer.add_step(at.time, mesh, coordinates_like(*target, writer, mesh, view), arrays);
        ++appended;
    }
    writer.finish();
    if (appended == 0) throw Error(options.from + ": has no step later than the last of " + options.dataset);
    std::cout << appended << " of " << source->steps().size() << " steps appended\n";
    return 0;
}

// From the order of the file that was imported to the order in which the dataset keeps it.
std::vector<float> to_stored_order(const store::NpyArray& file, std::span<const Index> original,
                                   std::size_t components) {
    std::vector<float> stored(original.size() * components);
    for (std::size_t i = 0; i < original.size(); ++i)
        for (std::size_t c = 0; c < components; ++c)
            stored[i * components + c] = file.values[original[i] * components + c];
    return stored;
}

// What a user types by mistake must not become an array for good. Names that came with a file are not judged.
void check_new_name(const std::string& name) {
    const std::string plain = name.starts_with(cell_prefix) ? name.substr(cell_prefix.size()) : name;
    const auto is_bad = [](unsigned char c) { return c < ' ' || c == 0x7f || c == '/' || c == '\\' || c == ':'; };
    std::string problem;
    if (plain.empty() || plain.front() == ' ' || plain.back() == ' ')
        problem = "is empty, or begins or ends with a space";
    else if (plain == "." || plain == "..")
        problem = "stands for a folder";
    else if (plain.size() > longest_name)
        problem = "is longer than " + std::to_string(longest_name) + " bytes";
    else if (std::any_of(plain.begin(), plain.end(), is_bad))
        problem = "holds a '/', '\\', ':' or control character (only 'cell:' may stand before it)";
    if (!problem.empty())
        throw Error("--array '" + name + "': the dataset has no such array, and a new one cannot have a name that " +
                    problem);
}

store::ArrayInfo describe(const Dataset& dataset, const std::string& name, int components) {
    if (const store::ArrayInfo* known = dataset.find(name)) return *known;
    check_new_name(name);
    return {name, name.starts_with(cell_prefix) ? Association::cell : Association::point, components, "", ""};
}

// A misspelt name makes a new array, and an array that was forgotten has no value at the step.
std::string what_differs(const Dataset& dataset, const std::vector<ArrayValues>& written) {
    std::string fresh, missing;
    const auto add = [](std::string& list, const std::string& name) { list += (list.empty() ? "" : ", ") + name; };
    for (const ArrayValues& array : written)
        if (dataset.find(array.info.name) == nullptr) add(fresh, array.info.name);
    for (const store::ArrayInfo& known : dataset.info().arrays)
        if (std::none_of(written.begin(), written.end(), [&](const auto& a) { return a.info.name == known.name; }))
            add(missing, known.name);
    return (fresh.empty() ? "" : "; new arrays: " + fresh) + (missing.empty() ? "" : "; not written: " + missing);
}

int append_files(const Options& options) {
    const auto dataset = Dataset::open(options.dataset);
    const std::size_t mesh = dataset->steps().empty() ? 0 : dataset->steps().back().mesh;
    const std::size_t coordinates = dataset->steps().empty() ? 0 : dataset->steps().back().coordinates;
    std::vector<std::vector<float>> stored;
    std::vector<ArrayValues> arrays;
    for (const std::string& argument : options.arrays) {
        const auto equals = argument.rfind('=');
        if (equals == std::string::npos || equals == 0) throw Error("--array '" + argument + "' must be NAME=FILE.npy");
        const store::NpyArray file = store::read_npy(argument.substr(equals + 1));
        const std::size_t components = file.shape.size() > 1 ? file.shape[1] : 1;
        store::ArrayInfo info = describe(*dataset, argument.substr(0, equals), static_cast<int>(components));
        const bool on_points = info.association == Association::point;
        const auto original = on_points ? dataset->original_vertex(mesh) : dataset->original_cell(mesh);
        const std::size_t expected = on_points ? dataset->info().input_vertices : dataset->info().input_cells;
        const std::size_t highest = *std::max_element(original.begin(), original.end());
        if (file.shape[0] != expected || highest >= expected || static_cast<int>(components) != info.components)
            throw Error(argument.substr(equals + 1) + ": holds " + std::to_string(file.shape[0]) + " x " +
                        std::to_string(components) + " values where '" + info.name + "' needs " +
                        std::to_string(expected) + " x " + std::to_string(info.components) +
                        ", in the order of the imported file");
        stored.push_back(to_stored_order(file, original, components));
        arrays.push_back({std::move(info), stored.back()});
    }
    store::Writer writer = store::Writer::append(options.dataset);
    writer.add_step(*options.time, mesh, coordinates, arrays);
    writer.finish();
    std::cout << "1 step appended" << what_differs(*dataset, arrays) << '\n';
    return 0;
}

} // namespace

void add_append(CLI::App& app, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("append", "Add time steps to a dataset; who looks at it sees them arrive");
    command->add_option("dataset", options->dataset, "NAME.ciel")->required();
    auto* from = command->add_option("--from", options->from,
                                     "OTHER.ciel on the same mesh: its steps that are later than the last one");
    auto* time = command->add_option("--time", options->time, "The time of one step");
    auto* arrays =
        command->add_option("--array", options->arrays,
                            "NAME=FILE.npy: float values in the order of the imported file's points, or of its "
                            "cells for a name that begins with 'cell:'; may be repeated");
    time->needs(arrays)->excludes(from);
    arrays->needs(time)->excludes(from);
    command->callback([options, &run] {
        if (options->from.empty() && !options->time) throw CLI::RequiredError("--from, or --time with --array,");
        run = [options] { return options->from.empty() ? append_files(*options) : append_dataset(*options); };
    });
}

} // namespace ciel::app
