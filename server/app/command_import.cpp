// ciel import INPUT... -o NAME.ciel: runs ciel-import within limits and reports its progress.
#include "app/commands.hpp"
#include "app/import_folder.hpp"
#include "app/import_view.hpp"
#include "store/rewrite.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>

namespace server::app {

namespace {

struct ImportCommand {
    importing::ImportValues values;
    importing::ImportLimits limits;
};

void add_options(CLI::App& command, ImportCommand& import) {
    for (const importing::ImportOption& option : importing::import_options) {
        auto& given = import.values[std::string(option.name)];
        const std::string names(option.names);
        const std::string help(option.help);
        if (option.value.empty()) {
            command.add_flag_callback(
                names, [&given] { given = {"yes"}; }, help);
            continue;
        }
        CLI::Option* added = command.add_option(names, given, help);
        added->required(option.required)->type_name(std::string(option.value));
        if (!option.several) added->expected(1);
    }
    command
        .add_option("--memory-limit", import.limits.memory_gigabytes,
                    "Memory that the import may use; by default four fifths of the memory of the machine or container; "
                    "0: no limit.")
        ->type_name("GB")
        ->capture_default_str();
    command.add_option("--time-limit", import.limits.seconds, "Time that the import may take; 0: no limit.")
        ->type_name("SECONDS")
        ->capture_default_str();
    command
        .add_option("--stall-limit", import.limits.stalled_seconds,
                    "Time without progress after which the import is stopped; 0: no limit.")
        ->type_name("SECONDS")
        ->capture_default_str();
}

void check_limit(const char* option, double value) {
    if (!std::isfinite(value) || value < 0)
        throw UsageError(std::string(option) + " must be a number of 0 (no limit) or more");
}

void check(const ImportCommand& import) {
    check_limit("--memory-limit", import.limits.memory_gigabytes);
    check_limit("--time-limit", import.limits.seconds);
    check_limit("--stall-limit", import.limits.stalled_seconds);
    const auto& output = import.values.at("output");
    if (!output.empty() && output.back().empty()) throw UsageError("-o needs a name, NAME.ciel");
}

// CIEL_IMPORT_ALL is for servers that cannot read the sources later: the server in compose.yaml has no importer.
bool writes_all_steps(const importing::ImportValues& values) {
    const char* const all = std::getenv("CIEL_IMPORT_ALL");
    return all != nullptr && *all != '\0' && !values.at("output").empty() &&
           !store::is_dataset(values.at("inputs").front());
}

int run_command(const ImportCommand& import) {
    check(import);
    ImportView view(stdout);
    const auto& output = import.values.at("output");
    const bool list = !import.values.at("list").empty();
    importing::ImportListener listener = view.listener();
    if (list) listener.progress = [](double, const std::string&) {};
    const CancelOnSignal signals;
    importing::ImportValues values = import.values;
    if (writes_all_steps(values)) values["all"] = {"yes"};
    if (values["late-folder"].empty()) values["late-folder"] = {late_folder_in(default_import_folder()).string()};
    const importing::ImportEnd end = importing::run_import(values, import.limits, listener, signals.cancelled());
    view.clear();
    if (!end.problem.empty()) std::cerr << "ciel: " << end.problem << '\n';
    const std::string& written = output.empty() ? import.values.at("inputs").front() : output.back();
    if (!list && (end.exit_code == 0 || end.exit_code == 3)) std::printf("wrote %s\n", written.c_str());
    return end.exit_code;
}

} // namespace

void add_import(CLI::App& app, Run& run) {
    CLI::App* command = app.add_subcommand("import", "Import a simulation result into a dataset.");
    auto import = std::make_shared<ImportCommand>();
    add_options(*command, *import);
    command->callback([&run, import] { run = [import] { return run_command(*import); }; });
}

} // namespace server::app
