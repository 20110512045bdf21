// Binary messages of a client: pieces of uploads (protocol/frame.md).
#pragma once

#include "sessions/connection.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace server::engine {
class Server;
}

namespace server::methods {

// Thread-safe; never throws. A refused piece is answered with the notification append.refused. If the message is
// malformed or not allowed, returns the reason to close the connection.
[[nodiscard]] std::optional<std::string> receive_binary(engine::Server& server, const sessions::Connection& connection,
                                                        std::span<const std::uint8_t> message);

} // namespace server::methods
