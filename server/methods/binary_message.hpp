// Binary messages of a client: pieces of uploads (protocol/frame.md).
#pragma once

#include "session/connection.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace ciel::session {
class Server;
}

namespace ciel::methods {

// Thread-safe; never throws for any bytes. A piece that is not taken is answered by append.refused. Returns the reason
// when the message is none that this connection may send: it should be closed.
[[nodiscard]] std::optional<std::string> receive_binary(session::Server& server, const session::Connection& connection,
                                                        std::span<const std::uint8_t> message);

} // namespace ciel::methods
