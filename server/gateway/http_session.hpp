// One TCP connection: its HTTP requests in order, until it closes or becomes a WebSocket.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/context.hpp"

#include <memory>

namespace ciel::gateway {

// What draining, or cutting, does to a connection right now; runs on the connection's own executor. Draining comes a
// second time when answers are not waited for any more, and a third time when the client is not either.
using OnDrain = std::shared_ptr<std::function<void()>>;

struct ConnectionStart {
    asio::ip::tcp::socket socket;
    asio::ip::tcp::endpoint peer;
    bool is_of_trusted_proxy = false;
    std::shared_ptr<Connections::Ticket> ticket{}; // a refused one: answer 503 and close
    OnDrain on_drain{}, on_cut{};
};

// Runs on the socket's executor, a strand. Ends without throwing when the connection has ended.
asio::awaitable<void> http_session(ConnectionStart start, Context& context, asio::thread_pool& workers);

} // namespace ciel::gateway
