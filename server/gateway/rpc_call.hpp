// JSON-RPC in one HTTP POST.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/context.hpp"
#include "gateway/http_message.hpp"

namespace ciel::gateway {

// To be awaited on the stream's executor, while nothing else is read from the stream. A peer that closes its side
// before the answer has come has hung up: slow methods are then given up, and their answers are errors.
[[nodiscard]] asio::awaitable<Response> rpc_call(beast::tcp_stream& stream, const Request& request, bool has_token,
                                                 Context& context, asio::thread_pool& workers);

} // namespace ciel::gateway
