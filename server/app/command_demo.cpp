// ciel demo: makes the demo dataset.
#include "app/commands.hpp"
#include "demo/demo.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace server::app {
namespace {

void show_progress(double share, const char* what) {
    if (::isatty(STDERR_FILENO) == 0) return;
    std::fprintf(stderr, "\r\033[K%3.0f %%  %s%s", 100 * share, what, share >= 1 ? "\n" : "");
    std::fflush(stderr);
}

} // namespace

void add_demo(CLI::App& app, Run& run) {
    struct Options {
        std::string output = "demo.ciel";
        bool force = false;
        int coarseness = 1;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("demo", "Make the demo dataset: Voronoi cells and hexahedra, an unsteady vortex street.");
    command->add_option("-o,--output", options->output, "NAME.ciel")->capture_default_str();
    command
        ->add_option("--coarseness", options->coarseness,
                     "Factor on the length of the cells; a larger factor gives a smaller dataset")
        ->check(CLI::Range(1, demo::most_coarseness))
        ->capture_default_str();
    command->add_flag("--force", options->force, "Replace an existing dataset of the same name");
    command->callback([options, &run] {
        run = [options] {
            if (!options->output.ends_with(".ciel"))
                throw UsageError("-o " + options->output + ": the name of a dataset must end in .ciel");
            demo::write_demo(options->output, options->force, options->coarseness, show_progress);
            std::cout << options->output << '\n';
            return 0;
        };
    });
}

} // namespace server::app
