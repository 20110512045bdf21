// Accepts connections, keeps their limit, starts a session for each.
#pragma once

#include "gateway/asio.hpp"
#include "gateway/context.hpp"

namespace ciel::gateway {

// The first address of the host. Throws Error when it cannot be resolved.
[[nodiscard]] asio::ip::address resolve_host(const std::string& host);

// Throws Error that says what to do when the address cannot be bound.
[[nodiscard]] asio::ip::tcp::acceptor bind(asio::io_context& io, const asio::ip::address& address, unsigned short port);

// Until the acceptor is closed.
asio::awaitable<void> accept_connections(asio::ip::tcp::acceptor& acceptor, asio::io_context& io, Context& context,
                                         asio::thread_pool& workers);

} // namespace ciel::gateway
