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

// Thread-safe; never throws for any bytes. A piece that is not taken is answered by append.refused. Returns the reason
// when the message is none that this connection may send: it should be closed.
[[nodiscard]] std::optional<std::string> receive_binary(engine::Server& server, const sessions::Connection& connection,
                                                        std::span<const std::uint8_t> message);

} // namespace ciel::methods
