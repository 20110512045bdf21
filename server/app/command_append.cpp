// ciel append: adds time steps to a dataset. A server may serve the dataset at the same time.
#include "app/commands.hpp"
#include "store/append.hpp"
#include "store/format/npy.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

namespace server::app {
namespace {

using store::Dataset;
using store::LackingRanges;

struct Options {
    std::string dataset, from;
    std::optional<double> time;
    std::vector<std::string> arrays; // each NAME=FILE.npy
};

int append_dataset(const Options& options) {
    const auto source = Dataset::open(options.from);
    const auto appended = store::append_dataset(Dataset::open(options.dataset, LackingRanges::left_out), *source);
    std::cout << appended << " of " << source->steps().size() << " steps appended\n";
    return 0;
}

struct File {
    std::string path;
    store::NpyArray values;

    [[nodiscard]] std::size_t components() const { return values.shape.size() > 1 ? values.shape[1] : 1; }
};

void check_size(const File& file, const store::PlannedArray& planned) {
    const auto components = static_cast<std::size_t>(planned.info.components);
    if (file.values.shape[0] == planned.tuples && file.components() == components) return;
    throw ciel::Error(file.path + ": has " + std::to_string(file.values.shape[0]) + " x " +
                      std::to_string(file.components()) + " values; '" + planned.info.name + "' must have " +
                      std::to_string(planned.tuples) + " x " + std::to_string(components) +
                      ", in the order of the imported file");
}

// Returns console text about unexpected arrays. A misspelt name creates a new array; a forgotten array is not written.
std::string what_differs(const store::StepPlan& plan) {
    std::string text;
    const auto add = [&](const char* what, const std::vector<std::string>& names) {
        for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? what : ", ") + names[i];
    };
    std::vector<std::string> made;
    for (const auto& array : plan.arrays)
        if (array.made) made.push_back(array.made->name);
    add("; new arrays: ", plan.added);
    add("; made from cell values: ", made);
    add("; not written: ", plan.lacking);
    add("; rounded to float32, the type of the array in the dataset: ", plan.rounded);
    return text;
}

int append_files(const Options& options) {
    const auto dataset = Dataset::open(options.dataset, LackingRanges::left_out);
    std::vector<File> files;
    std::vector<store::WantedArray> wanted;
    for (const std::string& argument : options.arrays) {
        const auto equals = argument.rfind('=');
        if (equals == std::string::npos || equals == 0)
            throw ciel::Error("--array '" + argument + "' is not of the form NAME=FILE.npy");
        const std::string path = argument.substr(equals + 1);
        files.push_back({path, store::read_npy(path)});
        wanted.push_back({argument.substr(0, equals), std::nullopt, files.back().values.values.has_doubles()});
        if (dataset->find(wanted.back().name) == nullptr) wanted.back().components = files.back().components();
    }
    const store::StepPlan plan = store::plan_step(*dataset, *options.time, wanted);
    for (std::size_t i = 0; i < files.size(); ++i) check_size(files[i], plan.arrays[i]);
    const auto values_of = [&](std::size_t i) { return files[i].values.values; };
    const auto done = store::append_step(dataset, *options.time, wanted, values_of);
    std::cout << "1 step appended" << what_differs(done.plan) << '\n';
    return 0;
}

} // namespace

void add_append(CLI::App& app, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("append", "Add time steps to a dataset; open views of the dataset get the steps at once.");
    command->add_option("dataset", options->dataset, "NAME.ciel")->required();
    auto* from = command->add_option("--from", options->from,
                                     "Dataset OTHER.ciel on the same mesh, whose later steps are appended");
    auto* time = command->add_option("--time", options->time, "Time of the step");
    auto* arrays = command->add_option(
        "--array", options->arrays,
        "NAME=FILE.npy: float32 or float64 values in the order of the points of the imported file. A "
        "name that begins with 'cell:' needs values in the order of the cells, and "
        "point values are interpolated from the cell values. May be repeated");
    time->needs(arrays)->excludes(from);
    arrays->needs(time)->excludes(from);
    command->callback([options, &run] {
        if (options->from.empty() && !options->time) throw CLI::RequiredError("--from, or --time with --array,");
        run = [options] { return options->from.empty() ? append_files(*options) : append_dataset(*options); };
    });
}

} // namespace server::app
