// The subcommands of `ciel`: command_NAME.cpp each, listed in main.cpp. add_NAME adds the options to the parser and
// sets `run` if the command is chosen.
#pragma once

#include "ciel/types.hpp"

#include <functional>

namespace CLI {
class App;
}

namespace ciel::app {

// Called by main after parsing. Returns the process's exit code: 0 done, 1 failed, 2 wrong usage, 3 done with cells
// left out.
using Run = std::function<int()>;

// Invalid options. Thrown before a command has any effect.
class UsageError : public Error {
public:
    using Error::Error;
};

void add_append(CLI::App& app, Run& run);
void add_bench(CLI::App& app, Run& run);
void add_demo(CLI::App& app, Run& run);
void add_extract(CLI::App& app, Run& run);
void add_import(CLI::App& app, Run& run);
void add_info(CLI::App& app, Run& run);
void add_render(CLI::App& app, Run& run);
void add_serve(CLI::App& app, Run& run);

} // namespace ciel::app
