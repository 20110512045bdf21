// JSON-RPC 2.0 text in, text out: the one door to all methods, for WebSocket, HTTP POST and tests alike.
#pragma once

#include "session/connection.hpp"

#include <memory>
#include <string>
#include <string_view>

namespace ciel::session {
class Server; // datasets, sessions, limits: everything a method may reach
}

namespace ciel::methods {

// Thread-safe. Handles single requests, notifications and batches exactly as the specification says. Never throws for
// any input. Returns an empty string when nothing is to be answered (only notifications).
[[nodiscard]] std::string dispatch(session::Server& server, session::Connection& connection, std::string_view text);

} // namespace ciel::methods
