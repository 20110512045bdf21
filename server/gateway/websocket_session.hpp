// A WebSocket: texts and pieces of uploads in, handled in order on a worker thread; answers, notifications and frames
// out.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/context.hpp"
#include "gateway/http_request.hpp"
#include "gateway/http_session.hpp"

namespace ciel::gateway {

// `client` comes with its address, user and token; the rest is filled in here. Ends when the connection, its last
// method and its last write have ended.
asio::awaitable<void> websocket_session(beast::tcp_stream stream, HttpRequest upgrade, Client client, OnDrain on_drain,
                                        Context& context, asio::thread_pool& workers);

} // namespace ciel::gateway
