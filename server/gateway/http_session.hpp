// One TCP connection. Answers its HTTP requests in order until it closes or becomes a WebSocket.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/gateway_state.hpp"

#include <memory>

namespace server::gateway {

// The current drain or cut handler of a connection; empty when none is needed. Runs on the connection's executor. A
// drain handler is called up to three times. After the first call, the connection ends when its answers are sent. After
// the second call, it ends without the answers. After the third call, it does not wait for the client either.
using OnDrain = std::shared_ptr<std::function<void()>>;

struct ConnectionStart {
    asio::ip::tcp::socket socket;
    asio::ip::tcp::endpoint peer;
    bool is_of_trusted_proxy = false;
    std::shared_ptr<Connections::Ticket> ticket{}; // if is_refused(): answer 503 and close
    OnDrain on_drain{}, on_cut{};
};

// Runs on the socket's executor, which must be a strand. Returns without throwing when the connection has ended.
asio::awaitable<void> http_session(ConnectionStart start, GatewayState& state, asio::thread_pool& workers);

} // namespace server::gateway
