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

// Leaves out the body and the members that the connection sets: remote, id, address, is_of_own_user.
[[nodiscard]] Request plain_request(const HttpRequest& message);

// Returns the response to a read or parse error, or nothing if the peer has closed the connection.
[[nodiscard]] std::optional<Response> refused_bytes(const boost::system::error_code& error);

// A head must have one Host, and the end of the body must be known (RFC 9112, 6). Close the connection after a refusal.
[[nodiscard]] std::optional<Response> refused_head(const HttpRequest& message);

// Refuses a WebSocket handshake without subprotocol ciel.v1 or with an invalid key (RFC 6455, 4.2.1).
[[nodiscard]] std::optional<Response> refused_handshake(const HttpRequest& message);

// Formats a time for an HTTP header: "Sun, 06 Nov 1994 08:49:37 GMT" (RFC 9110, 5.6.7).
[[nodiscard]] std::string http_date(std::time_t time);

} // namespace server::gateway
