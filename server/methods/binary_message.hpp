// Binary messages of a client: pieces of uploads (protocol/frame.md).
#pragma once

#include "sessions/connection.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace ciel::engine {
class Server;
}

namespace ciel::methods {

// Thread-safe; never throws for any bytes. A refused piece is answered with append.refused. Returns a reason if this
// connection may not send the message; the caller should then close it.
[[nodiscard]] std::optional<std::string> receive_binary(engine::Server& server, const sessions::Connection& connection,
                                                        std::span<const std::uint8_t> message);

} // namespace ciel::methods
