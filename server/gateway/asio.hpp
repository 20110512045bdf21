// The parts of Asio and Beast that every file of the sockets' side uses.
#pragma once

#include <utility> // Boost 1.74's awaitable uses std::exchange and does not include it

#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core/tcp_stream.hpp>

#include <string>

namespace ciel::gateway {

namespace asio = boost::asio;
namespace beast = boost::beast;
using boost::system::error_code;

// Methods may take long: they run here, never on the threads of the sockets. Coroutines come back to their own
// executor.
template <typename Work>
asio::awaitable<std::string> on_worker(asio::thread_pool& workers, Work work) {
    auto task = [&work]() -> asio::awaitable<std::string> { co_return work(); };
    co_return co_await asio::co_spawn(workers, std::move(task), asio::use_awaitable);
}

} // namespace ciel::gateway
