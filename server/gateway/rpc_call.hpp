// POST /rpc: a JSON-RPC text as an HTTP request.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/gateway_state.hpp"
#include "gateway/http_message.hpp"

namespace server::gateway {

// Await this on the stream's executor. Nothing else may read from the stream meanwhile. If the peer closes its side
// before the answer, slow methods are cancelled and answer with an error. Frees the body of `request` before it waits
// for a queued call.
[[nodiscard]] asio::awaitable<Response> rpc_call(beast::tcp_stream& stream, Request& request, bool has_token,
                                                 GatewayState& state, asio::thread_pool& workers);

} // namespace server::gateway
