// Adds an option and an environment variable for each row of limits/limits.hpp.
#pragma once

namespace CLI {
class App;
}
namespace server::limits {
struct Limits;
}

namespace server::app {

// Adds the options to `command`. `limits` is set when `command` is parsed, and must outlive `command`.
void add_limits(CLI::App& command, limits::Limits& limits);

} // namespace server::app
