#include "app/commands.hpp"
#include "ciel/types.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <vector>

namespace {

using AddCommand = void (*)(CLI::App& app, ciel::app::Run& run);

// In the order that --help shows.
const std::vector<AddCommand> commands{
    ciel::app::add_import,  ciel::app::add_info,   ciel::app::add_append, ciel::app::add_demo,
    ciel::app::add_extract, ciel::app::add_render, ciel::app::add_serve,
};

} // namespace

int main(int argc, char** argv) { // NOLINT(bugprone-exception-escape): only a fault of ours can throw before parsing
    CLI::App app{"CIEL: explore huge simulation results on unstructured meshes in a browser.", "ciel"};
    app.set_version_flag("--version", "ciel " CIEL_VERSION);
    app.require_subcommand(1);
    ciel::app::Run run;
    for (const auto add : commands) add(app, run);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        return run();
    } catch (const std::exception& error) {
        std::cerr << "ciel: " << error.what() << '\n';
        return 1;
    }
}
