// A WebSocket: texts in, handled in order on a worker thread; answers, notifications and frames out.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/context.hpp"
#include "gateway/http_request.hpp"
#include "gateway/http_session.hpp"

namespace ciel::gateway {

// Ends when the connection, its last method and its last write have ended.
asio::awaitable<void> websocket_session(beast::tcp_stream stream, HttpRequest upgrade, std::string remote,
                                        OnDrain on_drain, Context& context, asio::thread_pool& workers);

} // namespace ciel::gateway
