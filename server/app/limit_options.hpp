// An option and an environment variable for each row of limits/limits.hpp.
#pragma once

namespace CLI {
class App;
}
namespace ciel::limits {
struct Limits;
}

namespace ciel::app {

// `limits` must live until the command line has been parsed.
void add_limits(CLI::App& command, limits::Limits& limits);

} // namespace ciel::app
