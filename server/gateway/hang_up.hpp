// Distinguishes a peer that has closed its side of a connection from a peer that waits.
#pragma once

#include "gateway/asio.hpp"

namespace ciel::gateway {

enum class PeerState { waits, sends, hung_up };

// Looks at the next byte of the socket without removing it from the input, and without blocking. May return `waits`
// even if async_wait has reported the socket as readable, because another thread can read the bytes before this call.
[[nodiscard]] PeerState state_of_peer(asio::ip::tcp::socket& socket);

} // namespace ciel::gateway
