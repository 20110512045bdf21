// The subcommands of `ciel`: command_NAME.cpp each, listed in main.cpp. add_NAME puts its options on the parser and
// sets `run` when it was chosen.
#pragma once

#include "ciel/types.hpp"

#include <functional>

namespace CLI {
class App;
}

namespace ciel::app {

// What main calls after parsing; returns the process's exit code: 0 done, 1 failed, 2 wrong usage, 3 done with cells
// left out.
using Run = std::function<int()>;

// What a command was told makes no sense; it has done nothing yet.
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
