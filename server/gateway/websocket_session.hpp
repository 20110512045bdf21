// Session of one WebSocket. Incoming texts and upload pieces are handled in order on worker threads.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/gateway_state.hpp"
#include "gateway/http_request.hpp"
#include "gateway/http_session.hpp"

namespace server::gateway {

// The caller sets remote, user, has_token and the request of `client`: the id of `upgrade`, which the answer and the
// log have. Calls get ids of their own. Returns when the connection, its calls and writes have ended.
asio::awaitable<void> websocket_session(beast::tcp_stream stream, HttpRequest upgrade, Client client, OnDrain on_drain,
                                        GatewayState& state, asio::thread_pool& workers);

} // namespace server::gateway
