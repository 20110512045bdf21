// Converts Beast's requests to plain data, and refuses malformed requests before routing.
#pragma once

#include "gateway/http_message.hpp"

#include <boost/beast/core/error.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <ctime>
#include <optional>

namespace server::gateway {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;

// Converts a message without its body. The connection sets remote, id, address and is_of_own_user.
[[nodiscard]] Request plain_request(const HttpRequest& message);

// Returns the response to a read or parse error, or nothing if the peer has closed the connection.
[[nodiscard]] std::optional<Response> refused_bytes(const boost::system::error_code& error);

// Refuses a head of HTTP/1.1 without exactly one Host, and a body whose end is unknown (RFC 9112, 6). The caller must
// close the connection after a refusal.
[[nodiscard]] std::optional<Response> refused_head(const HttpRequest& message);

// Refuses a WebSocket handshake without subprotocol ciel.v1 or with an invalid key (RFC 6455, 4.2.1).
[[nodiscard]] std::optional<Response> refused_handshake(const HttpRequest& message);

// Formats a time for an HTTP header: "Sun, 06 Nov 1994 08:49:37 GMT" (RFC 9110, 5.6.7).
[[nodiscard]] std::string http_date(std::time_t time);

} // namespace server::gateway
