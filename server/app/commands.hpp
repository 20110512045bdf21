// Declares the subcommands of `ciel`. add_NAME adds a subcommand to the parser; choosing the subcommand sets `run`.
#pragma once

#include "ciel/types.hpp"

#include <functional>

namespace CLI {
class App;
}

namespace server::app {

// Returns the exit code of the process: 0 means done, 1 failed, 2 wrong usage, 3 done with data left out.
using Run = std::function<int()>;

// Thrown for invalid options, before a command has any effect.
class UsageError : public ciel::Error {
public:
    using ciel::Error::Error;
};

void add_append(CLI::App& app, Run& run);
void add_bench(CLI::App& app, Run& run);
void add_demo(CLI::App& app, Run& run);
void add_extract(CLI::App& app, Run& run);
void add_import(CLI::App& app, Run& run);
void add_info(CLI::App& app, Run& run);
void add_render(CLI::App& app, Run& run);
void add_serve(CLI::App& app, Run& run);

} // namespace server::app
