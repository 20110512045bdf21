// Accepts TCP connections within the limits and starts an HTTP session for each.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/gateway_state.hpp"

namespace server::gateway {

// Returns the first address of the host. Throws Error if the host cannot be resolved.
[[nodiscard]] asio::ip::address resolve_host(const std::string& host);

// Throws Error, which suggests a solution, if the address and port cannot be bound.
[[nodiscard]] asio::ip::tcp::acceptor bind(asio::io_context& io, const asio::ip::address& address, unsigned short port);

// Accepts connections until the acceptor is closed.
asio::awaitable<void> accept_connections(asio::ip::tcp::acceptor& acceptor, asio::io_context& io, GatewayState& state,
                                         asio::thread_pool& workers);

} // namespace server::gateway
