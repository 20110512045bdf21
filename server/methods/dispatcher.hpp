// JSON-RPC 2.0 text in, text out: the only entry to all methods, for WebSocket, HTTP POST and tests.
#pragma once

#include "sessions/connection.hpp"

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace ciel::engine {
class Server; // datasets, sessions, limits: everything a method may use
}

namespace ciel::methods {

// Gets an empty text if there is no answer (only notifications). Must not throw.
using Answer = std::function<void(std::string text)>;

// Thread-safe. Handles single requests, notifications and batches exactly as the specification says. Never throws for
// any input. `answer` is called exactly once: before this returns, or, when the text asks for a slow method, perhaps
// later and from another thread. The requests of a batch are handled in order.
void dispatch(engine::Server& server, std::shared_ptr<sessions::Connection> connection, std::string_view text,
              Answer answer);
// The same, but waits for the answer and returns it.
[[nodiscard]] std::string dispatch(engine::Server& server, sessions::Connection& connection, std::string_view text);

} // namespace ciel::methods
