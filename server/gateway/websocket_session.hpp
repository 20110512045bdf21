// A WebSocket: texts and pieces of uploads in, handled in order on a worker thread; answers, notifications and frames
// out.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/context.hpp"
#include "gateway/http_request.hpp"
#include "gateway/http_session.hpp"

namespace ciel::gateway {

struct WebSocketPeer {
    std::string remote;     // address, for logs
    std::string user;       // for logs; empty: not known
    bool has_token = false; // session::Connection
};

// Ends when the connection, its last method and its last write have ended.
asio::awaitable<void> websocket_session(beast::tcp_stream stream, HttpRequest upgrade, WebSocketPeer peer,
                                        OnDrain on_drain, Context& context, asio::thread_pool& workers);

} // namespace ciel::gateway
