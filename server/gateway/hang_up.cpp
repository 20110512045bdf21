#include "gateway/hang_up.hpp"

#include <cerrno>
#include <sys/socket.h>

namespace server::gateway {

PeerState state_of_peer(asio::ip::tcp::socket& socket) {
    char next = 0;
    const auto bytes = ::recv(socket.native_handle(), &next, 1, MSG_PEEK | MSG_DONTWAIT);
    if (bytes > 0) return PeerState::sends;
    const bool none_yet = bytes < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
    return none_yet ? PeerState::waits : PeerState::hung_up;
}

} // namespace server::gateway
