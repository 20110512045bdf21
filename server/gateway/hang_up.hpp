// Tells a peer that has closed its side of a connection from one that waits.
#pragma once

#include "gateway/asio.hpp"

namespace ciel::gateway {

enum class PeerState { waits, sends, hung_up };

// Looks at the socket's input without taking it and without waiting. A socket that async_wait calls readable may have
// no input: with several threads, its event may be that of bytes that another thread has read since.
[[nodiscard]] PeerState state_of_peer(asio::ip::tcp::socket& socket);

} // namespace ciel::gateway
