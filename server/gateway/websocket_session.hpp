// Session of one WebSocket. Incoming texts and upload pieces are handled in order on worker threads. Answers,
// notifications and frames are sent from an SendQueue.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/context.hpp"
#include "gateway/http_request.hpp"
#include "gateway/http_session.hpp"

namespace ciel::gateway {

// Serves one WebSocket. The caller sets remote, user and has_token of `client`; the session sets the other members.
// Returns when the connection, its last call and its last write have ended.
asio::awaitable<void> websocket_session(beast::tcp_stream stream, HttpRequest upgrade, Client client, OnDrain on_drain,
                                        Context& context, asio::thread_pool& workers);

} // namespace ciel::gateway
