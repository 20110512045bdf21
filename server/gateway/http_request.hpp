// Beast's requests as plain data, and what is wrong with them before any route is looked for.
#pragma once

#include "gateway/http_message.hpp"

#include <boost/beast/core/error.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <ctime>
#include <optional>

namespace ciel::gateway {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;

// Without the body and what only the connection knows.
[[nodiscard]] Request plain_request(const HttpRequest& message);

// The answer to what is not HTTP as we read it; nothing when the peer has gone.
[[nodiscard]] std::optional<Response> refused_bytes(const boost::system::error_code& error);

// The answer to a head after which the body cannot be told from the next request (RFC 9112, 6): the connection must
// be closed.
[[nodiscard]] std::optional<Response> refused_head(const HttpRequest& message);

// The answer to a WebSocket's handshake that is none of ours (RFC 6455, 4.2.1).
[[nodiscard]] std::optional<Response> refused_handshake(const HttpRequest& message);

// "Sun, 06 Nov 1994 08:49:37 GMT" (RFC 9110, 5.6.7).
[[nodiscard]] std::string http_date(std::time_t time);

} // namespace ciel::gateway
