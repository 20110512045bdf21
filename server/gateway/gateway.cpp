#include "gateway/gateway.hpp"

#include "ciel/types.hpp"
#include "gateway/listener.hpp"
#include "gateway/target.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/strand.hpp>
#include <csignal>
#include <cstdlib>
#include <spdlog/spdlog.h>
#include <thread>

namespace server::gateway {
namespace {

using Clock = std::chrono::steady_clock;

AccessRules access_rules(const GatewayOptions& options, bool loopback, unsigned short port) {
    if (!options.token.empty()) check_token_form(options.token);
    AccessRules rules;
    rules.token = options.token.empty() ? generate_token() : options.token;
    rules.own_user_enters = loopback && options.token.empty();
    rules.loopback = loopback;
    rules.allowed_hosts = options.allowed_hosts;
    rules.origins = options.origins;
    rules.cookie_name = "ciel_token_" + std::to_string(port);
    rules.cookie_path = normal_prefix(options.prefix) + "/";
    return rules;
}

// Owns the listening socket and the threads of the gateway until the drain has ended.
class Gateway {
public:
    Gateway(Service& service, const GatewayOptions& options)
        : address_(resolve_host(options.host)), acceptor_(bind(io_, address_, options.port)),
          threads_(std::max(1U, options.threads)), workers_(std::max(1U, options.workers)),
          state_(service, options, access_rules(options, address_.is_loopback(), acceptor_.local_endpoint().port())) {}

    int run(const std::function<void(const Listening&)>& on_listening) {
        asio::co_spawn(one_at_a_time_, drain_on_signal(), asio::detached);
        on_listening(listening());
        asio::co_spawn(one_at_a_time_, accept_connections(acceptor_, io_, state_, workers_), asio::detached);
        std::vector<std::jthread> threads;
        for (unsigned i = 1; i < threads_; ++i) threads.emplace_back([this] { io_.run(); });
        io_.run();
        threads.clear();
        if (!drained_) abandon();
        state_.owners.join();
        state_.probe_thread.join();
        workers_.join();
        return 0;
    }

private:
    Listening listening() const {
        const std::string text = address_.to_string();
        return {address_.is_v6() ? "[" + text + "]" : text, acceptor_.local_endpoint().port(), state_.prefix,
                state_.access.token};
    }

    asio::awaitable<void> drain_on_signal() {
        error_code ignored;
        co_await signals_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        signals_.async_wait([](const error_code& error, int signal) {
            if (!error) std::_Exit(128 + signal);
        });
        co_await drain();
        signals_.cancel();
        io_.stop();
    }

    asio::awaitable<void> drain() {
        spdlog::info("stopping: {} connections", state_.connections.count());
        const auto begin = Clock::now();
        const auto half = std::chrono::milliseconds(500) * state_.service.limits().drain_seconds;
        const auto is_over = [this] { return server_drained_ && state_.connections.count() == 0; };
        acceptor_.close();
        state_.draining = true;
        state_.service.announce_end();
        asio::post(workers_, [this] {
            state_.service.drain_frames();
            frames_drained_ = true;
            state_.service.drain();
            server_drained_ = true;
        });
        co_await until(begin + half, [this] { return frames_drained_.load(); });
        state_.connections.drain_all(); // first call: a connection ends when its answers have been sent
        co_await until(begin + half, is_over);
        state_.service.give_up();
        state_.connections.drain_all(); // second call: connections end without waiting for answers
        co_await until(begin + half * 3 / 2, is_over);
        state_.connections.drain_all();                // third call: connections end without waiting for the client
        co_await until(begin + half * 9 / 5, is_over); // leaves a tenth of drain_seconds for the exit
        drained_ = is_over();
    }

    template <typename Condition>
    asio::awaitable<void> until(Clock::time_point deadline, Condition condition) {
        asio::steady_timer timer(io_);
        while (!condition() && Clock::now() < deadline) {
            timer.expires_after(std::chrono::milliseconds(10));
            error_code ignored;
            co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        }
    }

    // Runs no destructors: running calls still use the service. An interrupted append.commit changes no dataset.
    [[noreturn]] static void abandon() {
        spdlog::warn("the server stopped before all requests were answered");
        spdlog::shutdown();
        std::_Exit(0);
    }

    asio::io_context io_;
    asio::signal_set signals_{io_, SIGINT, SIGTERM}; // keeps a signal that arrives before async_wait()
    // Serializes accepting and draining, because draining closes the acceptor.
    asio::strand<asio::io_context::executor_type> one_at_a_time_{asio::make_strand(io_)};
    asio::ip::address address_;
    asio::ip::tcp::acceptor acceptor_;
    unsigned threads_;
    asio::thread_pool workers_;
    GatewayState state_;
    std::atomic<bool> frames_drained_{false}, server_drained_{false};
    bool drained_ = false;
};

} // namespace

int serve(Service& service, const GatewayOptions& options, const std::function<void(const Listening&)>& on_listening) {
    Gateway gateway(service, options);
    return gateway.run(on_listening);
}

} // namespace server::gateway
