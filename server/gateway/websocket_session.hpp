// A WebSocket. Texts and upload pieces come in and are handled in order on worker threads; answers, notifications and
// frames go out.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/context.hpp"
#include "gateway/http_request.hpp"
#include "gateway/http_session.hpp"

namespace ciel::gateway {

// `client` has remote, user and has_token set; the other members are set here. Ends after the connection, its last call
// and its last write have ended.
asio::awaitable<void> websocket_session(beast::tcp_stream stream, HttpRequest upgrade, Client client, OnDrain on_drain,
                                        Context& context, asio::thread_pool& workers);

} // namespace ciel::gateway
