#include "gateway/listener.hpp"

#include "ciel/types.hpp"
#include "gateway/http_session.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/strand.hpp>
#include <spdlog/spdlog.h>

namespace ciel::gateway {
namespace {

using asio::ip::tcp;

// Beyond the limit, so many more hear why; the rest are closed without a word.
constexpr std::size_t refusals_at_once = 32;

ConnectionStart start_of(tcp::socket socket, Context& context, bool over_limit) {
    auto on_drain = std::make_shared<std::function<void()>>();
    auto drain = [on_drain, executor = socket.get_executor()] {
        asio::post(executor, [on_drain] {
            if (*on_drain) (*on_drain)();
        });
    };
    auto ticket = std::make_shared<Connections::Ticket>(context.connections, std::move(drain));
    return {std::move(socket), std::move(ticket), std::move(on_drain), over_limit};
}

void start_session(tcp::socket socket, Context& context, asio::thread_pool& workers) {
    const std::size_t open = context.connections.count(), limit = context.server.limits().connections;
    ++context.counters.connections;
    if (open >= limit) ++context.counters.refused_connections;
    if (open >= limit + refusals_at_once) return;
    error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    const auto executor = socket.get_executor();
    auto start = start_of(std::move(socket), context, open >= limit);
    asio::co_spawn(executor, http_session(std::move(start), context, workers), [](const std::exception_ptr& failure) {
        try {
            if (failure) std::rethrow_exception(failure);
        } catch (const std::exception& error) {
            spdlog::error("a connection ended: {}", error.what());
        }
    });
}

} // namespace

asio::ip::address resolve_host(const std::string& host) {
    asio::io_context io;
    tcp::resolver resolver(io);
    error_code error;
    const auto found = resolver.resolve(host, "", error);
    if (error || found.empty())
        throw Error("the host " + host + " cannot be resolved (" + error.message() + "); name an address with --host");
    return found.begin()->endpoint().address();
}

tcp::acceptor bind(asio::io_context& io, const asio::ip::address& address, unsigned short port) {
    const tcp::endpoint endpoint(address, port);
    const std::string name =
        (address.is_v6() ? "[" + address.to_string() + "]" : address.to_string()) + ":" + std::to_string(port);
    tcp::acceptor acceptor(io);
    error_code error;
    acceptor.open(endpoint.protocol(), error);
    if (!error) acceptor.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error == asio::error::address_in_use)
        throw Error(name +
                    " is in use by another program; end it, or choose another port with --port (0: any free one)");
    if (error == asio::error::access_denied)
        throw Error(name + " may not be bound by this user; choose a port above 1023 with --port");
    if (error)
        throw Error(name + " cannot be bound (" + error.message() + "); name an address of this machine with --host");
    return acceptor;
}

asio::awaitable<void> accept_connections(tcp::acceptor& acceptor, asio::io_context& io, Context& context,
                                         asio::thread_pool& workers) {
    asio::steady_timer pause(io);
    while (acceptor.is_open()) {
        tcp::socket socket(asio::make_strand(io));
        error_code error;
        co_await acceptor.async_accept(socket, asio::redirect_error(asio::use_awaitable, error));
        if (!error)
            start_session(std::move(socket), context, workers);
        else if (error != asio::error::operation_aborted) { // out of file descriptors: connections have to end first
            spdlog::warn("a connection was not accepted: {}", error.message());
            pause.expires_after(std::chrono::milliseconds(100));
            co_await pause.async_wait(asio::redirect_error(asio::use_awaitable, error));
        }
    }
}

} // namespace ciel::gateway
