// Tells a peer that has closed its side of a connection from one that waits.
#pragma once

#include "gateway/asio.hpp"

namespace ciel::gateway {

enum class PeerState { waits, sends, hung_up };

// Looks at the socket's input without taking it and without waiting. Returns `waits` even for some sockets that
// async_wait has reported as readable: another thread can read the bytes before this call.
[[nodiscard]] PeerState state_of_peer(asio::ip::tcp::socket& socket);

} // namespace ciel::gateway
