// An option and an environment variable for each row of session/limits.hpp.
#pragma once

namespace CLI {
class App;
}
namespace ciel::session {
struct Limits;
}

namespace ciel::app {

// `limits` must live until the command line has been parsed.
void add_limits(CLI::App& command, session::Limits& limits);

} // namespace ciel::app
