// Distinguishes a peer that has closed its side of a connection from a peer that waits.
#pragma once

#include "gateway/asio.hpp"

namespace server::gateway {

enum class PeerState { waits, sends, hung_up };

// Looks at the next byte without removing it, and without blocking. May return `waits` even after async_wait has
// reported bytes, because another thread can read them before this call.
[[nodiscard]] PeerState state_of_peer(asio::ip::tcp::socket& socket);

} // namespace server::gateway
