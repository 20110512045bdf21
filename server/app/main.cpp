#include "app/commands.hpp"
#include "ciel/types.hpp"
#include "store/files/files.hpp"

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace {

constexpr int failed = 1, wrong_usage = 2;

using AddCommand = void (*)(CLI::App& app, server::app::Run& run);

// The subcommands, in the order in which --help lists them.
const std::vector<AddCommand> commands{
    server::app::add_import,  server::app::add_info,   server::app::add_append, server::app::add_demo,
    server::app::add_extract, server::app::add_render, server::app::add_serve,  server::app::add_bench,
};

std::string sentence(const CLI::App& app, const CLI::ParseError& error) {
    const auto unknown = app.remaining(); // arguments before a command, or without a command
    const auto chosen = app.get_subcommands();
    if (unknown.empty() && !chosen.empty())
        return std::string(error.what()) + "; see `ciel " + chosen.front()->get_name() + " --help`";
    std::string names;
    for (const CLI::App* command : app.get_subcommands({})) names += (names.empty() ? "" : ", ") + command->get_name();
    const std::string problem = unknown.empty() ? "a command is missing" : "there is no command '" + unknown[0] + "'";
    return problem + "; the commands are " + names + "; `ciel --help` describes each";
}

int fail(const std::string& sentence, int exit_code) {
    std::cerr << "ciel: " << sentence << '\n';
    return exit_code;
}

} // namespace

int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape): only a bug can throw before parsing
    std::signal(SIGXFSZ, SIG_IGN); // a file beyond a limit of the shell (ulimit -f) is then an error
    CLI::App app{"CIEL: explore huge simulation results on unstructured meshes in a browser.", "ciel"};
    app.set_version_flag("--version", "ciel " CIEL_VERSION);
    app.require_subcommand(1);
    app.footer("Exit codes: 0 done, 1 failed, 2 wrong usage, 3 done with cells left out.");
    server::app::Run run;
    for (const auto add : commands) add(app, run);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return error.get_exit_code() == 0 ? app.exit(error) : fail(sentence(app, error), wrong_usage);
    }
    try {
        return run();
    } catch (const server::app::UsageError& error) {
        return fail(error.what(), wrong_usage);
    } catch (const std::exception& error) {
        const bool lacks_memory = server::store::is_out_of_memory(error);
        return fail(lacks_memory ? "this machine does not have enough memory; ask for less, or end other programs"
                                 : error.what(),
                    failed);
    }
}
