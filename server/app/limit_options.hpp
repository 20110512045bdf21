// Adds an option and an environment variable for each row of limits/limits.hpp.
#pragma once

namespace CLI {
class App;
}
namespace ciel::limits {
struct Limits;
}

namespace ciel::app {

// `limits` is set by parsing and must outlive it.
void add_limits(CLI::App& command, limits::Limits& limits);

} // namespace ciel::app
