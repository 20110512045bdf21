// One TCP connection. Answers its HTTP requests in order until it closes or becomes a WebSocket.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/context.hpp"

#include <memory>

namespace ciel::gateway {

// Current drain or cut handler of a connection; runs on the connection's executor. Drain is called up to three times:
// to finish, then to end without waiting for answers, then to end without waiting for the client.
using OnDrain = std::shared_ptr<std::function<void()>>;

struct ConnectionStart {
    asio::ip::tcp::socket socket;
    asio::ip::tcp::endpoint peer;
    bool is_of_trusted_proxy = false;
    std::shared_ptr<Connections::Ticket> ticket{}; // if refused: answer 503 and close
    OnDrain on_drain{}, on_cut{};
};

// Runs on the socket's executor, a strand. Ends without throwing when the connection has ended.
asio::awaitable<void> http_session(ConnectionStart start, Context& context, asio::thread_pool& workers);

} // namespace ciel::gateway
