// ciel-import: reads simulation results and writes the dataset NAME.ciel. `ciel` starts this program as a child
// process. `ciel` reads its "progress SHARE PHASE", "note SENTENCE" and "memory FIGURES" lines from standard output,
// and one error sentence from standard error.
#include "ciel/types.hpp"
#include "import/convert.hpp"
#include "import/late_steps.hpp"
#include "import/listing.hpp"
#include "import/progress.hpp"
#include "import/readers/open_source.hpp"
#include "import/readers/vtk_errors.hpp"
#include "importing/import_options.hpp"
#include "store/files/files.hpp"
#include "store/new_dataset_directory.hpp"
#include "store/rewrite.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <malloc.h>
#include <system_error>

namespace {

using server::importer::Options;

enum ExitCode : int {
    done = 0,
    failed = 1,
    wrong_usage = 2,
    something_lost = 3,
    out_of_memory = server::importing::import_out_of_memory,
};
constexpr double most_bad_cells = 0.001; // if the share of bad cells is larger, the exit code is something_lost

void add_options(CLI::App& app, server::importing::ImportValues& values) {
    for (const server::importing::ImportOption& option : server::importing::import_options) {
        auto& given = values[std::string(option.name)];
        const std::string names(option.names);
        const std::string help(option.help);
        if (option.value.empty()) {
            app.add_flag_callback(
                names, [&given] { given = {"yes"}; }, help);
            continue;
        }
        CLI::Option* added = app.add_option(names, given, help);
        added->required(option.required)->type_name(std::string(option.value));
        if (!option.several) added->expected(1);
    }
}

std::size_t step_number(const std::string& text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size())
        throw CLI::ValidationError("--step " + text + ": give the number of a step, counted from 0");
    return number;
}

// Late steps are read with the options of the import, because the arrays of all steps must be made in the same way.
void refuse_with_late_steps(const server::importing::ImportValues& values) {
    for (const char* option : {"output", "list", "array", "weld", "no-weld", "force", "plot3d"})
        if (!values.at(option).empty())
            throw CLI::ValidationError(
                std::string("--all and --step read steps in the way of the import; leave out --") + option);
}

Options options_from(server::importing::ImportValues& values) {
    const auto flag = [&](const char* name) { return !values[name].empty(); };
    Options options;
    options.inputs = values["inputs"];
    if (!values["output"].empty()) options.output = values["output"].back();
    options.arrays = values["array"];
    options.list = flag("list");
    options.all = flag("all");
    for (const std::string& step : values["step"]) options.steps.push_back(step_number(step));
    if (!values["late-folder"].empty()) options.late_folder = values["late-folder"].back();
    const bool reads_late_steps = options.inputs.size() == 1 && server::store::is_dataset(options.inputs.front()) &&
                                  (options.all || !options.steps.empty());
    if (!options.steps.empty() && !reads_late_steps)
        throw CLI::ValidationError("--step needs a dataset NAME.ciel as the only input");
    options.allow_bad = flag("allow-bad");
    options.force = flag("force");
    if (!values["plot3d"].empty()) options.source.plot3d = values["plot3d"].back();
    if (flag("weld") && flag("no-weld"))
        throw CLI::ValidationError("--weld and --no-weld exclude each other; give one of them");
    if (reads_late_steps) refuse_with_late_steps(values);
    if (!options.list && !reads_late_steps && options.output.empty()) throw CLI::RequiredError("-o NAME.ciel");
    if (!options.list && !reads_late_steps && !options.output.ends_with(".ciel"))
        throw CLI::ValidationError("-o " + options.output + ": the name of a dataset must end in .ciel");
    if (flag("weld")) options.weld = server::importer::Weld::all;
    if (flag("no-weld")) options.weld = server::importer::Weld::none;
    return options;
}

// The prefix lets the supervisor find the sentence, because libraries also write to standard error.
int fail(const std::string& sentence, ExitCode code = failed) {
    std::fprintf(stderr, "%s%s\n", server::importing::import_error_prefix.data(), sentence.c_str());
    return code;
}

int run_rewrite(const Options& options) {
    using namespace server::importer;
    const std::string& input = options.inputs.front();
    if (options.list) throw ciel::Error(input + ": is a dataset; use `ciel info` to list the content of a dataset");
    if (!options.arrays.empty() || options.weld != Weld::seams)
        throw ciel::Error(
            input +
            ": is a dataset, and a dataset is written again as a whole; leave out --array, --weld and --no-weld");
    const std::vector<std::string> left_out =
        server::store::rewrite(input, options.output, options.force,
                               [](double share) { progress(0.98 * share, "writing the dataset again"); });
    ignore_cancelling();
    for (const std::string& note : left_out) std::printf("note %s\n", note.c_str());
    progress(1.0, "done");
    if (left_out.empty() || options.allow_bad) return done;
    return fail(input + ": the dataset was written without a part of the input: " + left_out.front() +
                    " --allow-bad accepts the loss",
                something_lost);
}

int run_late_steps(const Options& options) {
    using namespace server::importer;
    read_late_steps({options.inputs.front(), options.steps, options.late_folder, options.allow_bad});
    ignore_cancelling();
    progress(1.0, "done");
    return done;
}

void print_memory(const server::importer::MemoryUse& use) {
    constexpr double megabyte = 1e6;
    const auto cells = static_cast<double>(std::max<std::uint64_t>(use.cells, 1));
    std::printf("memory %.0f MB after reading, at most %.0f MB more while writing (%.0f bytes a cell)\n",
                static_cast<double>(use.reader) / megabyte, static_cast<double>(use.beyond) / megabyte,
                static_cast<double>(use.beyond) / cells);
}

int run(const Options& options) {
    using namespace server::importer;
    install_cancel_handlers();
    capture_vtk_errors();
    if (!options.list && options.output.empty()) return run_late_steps(options);
    if (!options.list)
        server::store::check_new_dataset_directory(options.output, options.force); // before any input is read
    if (options.inputs.size() == 1 && server::store::is_dataset(options.inputs.front())) return run_rewrite(options);
    const auto source = open_source(options.inputs, options.source);
    if (options.list) {
        print_listing(*source);
        return done;
    }
    const ConvertResult result = convert(*source, options);
    // The dataset is complete. Without this call, an earlier signal would make progress() throw.
    ignore_cancelling();
    for (const std::string& note : result.notes) std::printf("note %s\n", note.c_str());
    if (result.late_steps > 0)
        std::printf("%zu steps are read from the source when they are needed. Keep the source, or read them now with "
                    "`ciel import "
                    "NAME.ciel --all`\n",
                    result.late_steps);
    print_memory(result.memory);
    progress(1.0, "done");
    std::vector<std::string> lost = result.lost;
    if (static_cast<double>(result.bad_cells) > most_bad_cells * static_cast<double>(result.cells))
        lost.push_back(std::to_string(result.bad_cells) + " of " + std::to_string(result.cells) +
                       " cells were left out");
    if (lost.empty() || options.allow_bad) return done;
    const std::string others =
        lost.size() > 1 ? " (" + std::to_string(lost.size() - 1) + " more are in the notes)" : "";
    return fail(options.inputs.front() + ": the dataset was written without a part of the input: " + lost.front() +
                    others + "; --allow-bad accepts the loss",
                something_lost);
}

// Adds the path of the input, because some errors, such as errors about the mesh, name no file.
std::string naming_input(const Options& options, const std::string& sentence) {
    const auto names = [&](const std::string& path) { return sentence.find(path) != std::string::npos; };
    const bool named =
        std::any_of(options.inputs.begin(), options.inputs.end(), names) ||
        (!options.output.empty() && names(std::filesystem::absolute(options.output).lexically_normal().string()));
    return named ? sentence : options.inputs.front() + ": " + sentence;
}

int run_and_report(const Options& options) {
    const std::string& input = options.inputs.front();
    try {
        return run(options);
    } catch (const server::importer::Cancelled&) {
        return fail("cancelled");
    } catch (const ciel::Error& error) {
        return fail(naming_input(options, error.what()));
    } catch (const std::exception& error) {
        if (server::store::is_out_of_memory(error))
            return fail(input + ": the import needs more memory than it may use; raise --memory-limit", out_of_memory);
        return fail(input + ": cannot be imported: " + error.what());
    }
}

// Without a fixed threshold, malloc takes ever larger arrays from its heap, and keeps their memory when they are freed.
void return_freed_arrays() { ::mallopt(M_MMAP_THRESHOLD, 1 << 20); }

} // namespace

int main(int argc, char** argv) { // NOLINT(bugprone-exception-escape): only a bug in CIEL can throw before parsing
    return_freed_arrays();
    std::signal(SIGXFSZ, SIG_IGN); // a file beyond a limit of the shell (ulimit -f) is then an error
    CLI::App app{"Reads a simulation result and writes a CIEL dataset.", "ciel-import"};
    server::importing::ImportValues values;
    add_options(app, values);
    Options options;
    try {
        app.parse(argc, argv);
        options = options_from(values);
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return fail(error.what(), wrong_usage);
    }
    return run_and_report(options);
}
