#include "gateway/listener.hpp"

#include "ciel/types.hpp"
#include "gateway/http_session.hpp"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/strand.hpp>
#include <filesystem>
#include <iterator>
#include <spdlog/spdlog.h>

namespace server::gateway {
namespace {

using asio::ip::tcp;

constexpr std::chrono::milliseconds pause_when_short{10}; // connections that were closed to make room can end meanwhile
constexpr std::chrono::milliseconds pause_after_failure{100};

std::size_t count_files() {
    std::error_code none; // without /proc, the count is 0, which may be too low
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator("/proc/self/fd", none), {}));
}

// A new socket gets the lowest free descriptor, so all lower ones are in use. Other connections may have higher ones.
bool is_short_of_files(tcp::socket& socket, std::size_t files_at_start, GatewayState& state) {
    const auto below = static_cast<std::size_t>(socket.native_handle());
    const std::size_t used = std::max(below, files_at_start + state.connections.count()) + 1;
    if (used + state.service.limits().reserved_files <= state.most_files) return false;
    if (state.log_limiter.allows("files"))
        spdlog::warn("{} of {} file descriptors are in use; the oldest idle connections are closed for new ones. Raise "
                     "the limit (ulimit -n)",
                     used, state.most_files);
    return true;
}

std::function<void()> posted(const tcp::socket::executor_type& executor,
                             const std::shared_ptr<std::function<void()>>& handler) {
    return [executor, handler] {
        asio::post(executor, [handler] {
            if (*handler) (*handler)();
        });
    };
}

void start_session(tcp::socket socket, bool is_short, GatewayState& state, asio::thread_pool& workers) {
    ++state.counters.connections;
    error_code gone;
    const auto peer = socket.remote_endpoint(gone);
    if (gone) return;
    ConnectionStart start{std::move(socket), peer};
    start.is_of_trusted_proxy = state.proxies.contains(start.peer.address());
    start.on_drain = std::make_shared<std::function<void()>>();
    start.on_cut = std::make_shared<std::function<void()>>();
    start.socket.set_option(tcp::no_delay(true), gone);
    const auto executor = start.socket.get_executor();
    start.ticket =
        state.connections.open(start.is_of_trusted_proxy ? std::string() : counting_key(start.peer.address()), is_short,
                               {posted(executor, start.on_drain), posted(executor, start.on_cut)});
    if (!start.ticket || start.ticket->is_refused()) ++state.counters.refused_connections;
    if (!start.ticket) return;
    asio::co_spawn(executor, http_session(std::move(start), state, workers), [](const std::exception_ptr& failure) {
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
        throw ciel::Error("the host " + host + " cannot be resolved (" + error.message() +
                          "); name an address with --host");
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
        throw ciel::Error(
            name +
            " is in use by another program; end that program, or choose another port with --port (0: any free port)");
    if (error == asio::error::access_denied)
        throw ciel::Error(name + " cannot be bound by this user; choose a port above 1023 with --port");
    if (error)
        throw ciel::Error(name + " cannot be bound (" + error.message() +
                          "); name an address of this machine with --host");
    return acceptor;
}

namespace {

void tell_not_accepted(GatewayState& state, const std::exception& failure) noexcept {
    try {
        if (state.log_limiter.allows("accept")) spdlog::warn("a connection was not accepted: {}", failure.what());
    } catch (const std::exception&) { // there is no memory for the log line either
    }
}

// Returns the pause after which the next connection may be accepted.
asio::awaitable<std::chrono::milliseconds> accept_connection(tcp::acceptor& acceptor, asio::io_context& io,
                                                             std::size_t files_at_start, GatewayState& state,
                                                             asio::thread_pool& workers) {
    constexpr std::chrono::milliseconds none{0};
    tcp::socket socket(asio::make_strand(io));
    error_code error;
    co_await acceptor.async_accept(socket, asio::redirect_error(asio::use_awaitable, error));
    if (error == asio::error::operation_aborted) co_return none;
    if (error) throw ciel::Error(error.message());
    const bool is_short = is_short_of_files(socket, files_at_start, state);
    start_session(std::move(socket), is_short, state, workers);
    co_return is_short ? pause_when_short : none;
}

} // namespace

asio::awaitable<void> accept_connections(tcp::acceptor& acceptor, asio::io_context& io, GatewayState& state,
                                         asio::thread_pool& workers) {
    const std::size_t files_at_start = count_files();
    asio::steady_timer pause(io);
    std::chrono::milliseconds wait{0};
    while (acceptor.is_open()) {
        try {
            error_code ignored;
            if (wait.count() > 0) {
                pause.expires_after(wait);
                co_await pause.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
            }
            wait = co_await accept_connection(acceptor, io, files_at_start, state, workers);
        } catch (const std::exception& failure) { // no descriptor or no memory is free; wait until connections end
            tell_not_accepted(state, failure);
            wait = pause_after_failure;
        }
    }
}

} // namespace server::gateway
