// ciel import INPUT... -o NAME.ciel: starts ciel-import and watches over it.
#include "app/commands.hpp"
#include "store/importer.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace ciel::app {

namespace {

std::atomic<bool> cancelled{false};
static_assert(std::atomic<bool>::is_always_lock_free); // set in a signal handler

void on_signal(int) { cancelled = true; }

struct ImportCommand {
    store::ImportValues values;
    store::ImportLimits limits;
};

void add_options(CLI::App& command, ImportCommand& import) {
    for (const store::ImportOption& option : store::import_options) {
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
    command.add_option("--memory-limit", import.limits.memory_gigabytes, "Memory the import may use; all by default.")
        ->type_name("GB")
        ->check(CLI::PositiveNumber);
    command.add_option("--time-limit", import.limits.seconds, "Time the import may take; none by default.")
        ->type_name("SECONDS")
        ->check(CLI::PositiveNumber);
}

// A bar on a terminal; elsewhere a line for every tenth.
class ProgressView {
public:
    void show(double share, const std::string& phase) {
        const int percent = static_cast<int>(std::clamp(share, 0.0, 1.0) * 100);
        if (terminal_) {
            const std::string done(static_cast<std::size_t>(percent) * width / 100, '#');
            std::fprintf(stderr, "\r[%-*s] %3d %% %-40.40s", width, done.c_str(), percent, phase.c_str());
        } else if (percent / 10 != shown_tenth_) {
            shown_tenth_ = percent / 10;
            std::printf("%d %% %s\n", percent, phase.c_str());
            std::fflush(stdout);
        }
    }
    void clear() const {
        if (terminal_) std::fprintf(stderr, "\r%*s\r", width + 52, "");
    }

private:
    static constexpr int width = 30;
    bool terminal_ = ::isatty(STDERR_FILENO) != 0;
    int shown_tenth_ = -1;
};

int run_command(const ImportCommand& import) {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    ProgressView view;
    const auto& output = import.values.at("output");
    const bool list = !import.values.at("list").empty();
    const store::ImportListener listener{[&](double share, const std::string& phase) {
                                             if (!list) view.show(share, phase);
                                         },
                                         [&](const std::string& line) {
                                             view.clear();
                                             std::printf("%s\n", line.c_str());
                                         }};
    const store::ImportEnd end = store::run_import(import.values, import.limits, listener, cancelled);
    view.clear();
    if (!end.problem.empty()) std::cerr << "ciel: " << end.problem << '\n';
    if (!list && (end.exit_code == 0 || end.exit_code == 3)) std::printf("wrote %s\n", output.back().c_str());
    return end.exit_code;
}

} // namespace

void add_import(CLI::App& app, Run& run) {
    CLI::App* command = app.add_subcommand("import", "Import a simulation result into a dataset.");
    auto import = std::make_shared<ImportCommand>();
    add_options(*command, *import);
    command->callback([&run, import] { run = [import] { return run_command(*import); }; });
}

} // namespace ciel::app
