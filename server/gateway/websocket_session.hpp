// Session of one WebSocket. Incoming texts and upload pieces are handled in order on worker threads.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/gateway_state.hpp"
#include "gateway/http_request.hpp"
#include "gateway/http_session.hpp"

namespace server::gateway {

// The caller sets remote, user, has_token and request of `client`. `request` is the id of `upgrade` in the HTTP
// response and in the log; each call gets a separate id. Returns when the connection, its calls and writes have ended.
asio::awaitable<void> websocket_session(beast::tcp_stream stream, HttpRequest upgrade, Client client, OnDrain on_drain,
                                        GatewayState& state, asio::thread_pool& workers);

} // namespace server::gateway
