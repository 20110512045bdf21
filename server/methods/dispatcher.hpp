// Takes a JSON-RPC 2.0 text and returns the answer. All methods are called only through dispatch().
#pragma once

#include "sessions/connection.hpp"

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace server::engine {
class Server; // datasets, sessions, limits: everything a method may use
}

namespace server::methods {

// Callback for the answer. The answer is an empty text if the text has only notifications. Must not throw.
using Answer = std::function<void(std::string text)>;

// Handles a request, a notification or a batch. Thread-safe. Never throws. `answer` is called exactly once: before
// dispatch returns or, if the text calls a slow method, possibly later from another thread.
void dispatch(engine::Server& server, std::shared_ptr<sessions::Connection> connection, std::string_view text,
              Answer answer);
// Waits for the answer and returns it.
[[nodiscard]] std::string dispatch(engine::Server& server, sessions::Connection& connection, std::string_view text);

} // namespace server::methods
