// Converts Beast's requests to plain data, and refuses malformed requests before routing.
#pragma once

#include "gateway/http_message.hpp"

#include <boost/beast/core/error.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <ctime>
#include <optional>

namespace ciel::gateway {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;

// Converts a request to plain data, except for its body and the members that the connection sets: remote, id, address,
// is_of_own_user.
[[nodiscard]] Request plain_request(const HttpRequest& message);

// Returns the response to a read or parse error, or nothing if the peer has closed the connection.
[[nodiscard]] std::optional<Response> refused_bytes(const boost::system::error_code& error);

// Returns the response that refuses a request head, or nothing for a valid head. A head of HTTP/1.1 must have exactly
// one Host, and the end of the body must be known (RFC 9112, 6). The connection must be closed after a refusal.
[[nodiscard]] std::optional<Response> refused_head(const HttpRequest& message);

// Returns the response that refuses a WebSocket handshake without subprotocol ciel.v1 or with an invalid key (RFC 6455,
// 4.2.1). Returns nothing for a valid handshake.
[[nodiscard]] std::optional<Response> refused_handshake(const HttpRequest& message);

// Formats a time for an HTTP header: "Sun, 06 Nov 1994 08:49:37 GMT" (RFC 9110, 5.6.7).
[[nodiscard]] std::string http_date(std::time_t time);

} // namespace ciel::gateway
