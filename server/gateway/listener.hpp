// Accepts connections within their limits and starts a session for each.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/context.hpp"

namespace ciel::gateway {

// Returns the first address of the host. Throws Error when it cannot be resolved.
[[nodiscard]] asio::ip::address resolve_host(const std::string& host);

// Throws Error when the address cannot be bound; its text suggests a fix.
[[nodiscard]] asio::ip::tcp::acceptor bind(asio::io_context& io, const asio::ip::address& address, unsigned short port);

// Runs until the acceptor is closed.
asio::awaitable<void> accept_connections(asio::ip::tcp::acceptor& acceptor, asio::io_context& io, Context& context,
                                         asio::thread_pool& workers);

} // namespace ciel::gateway
