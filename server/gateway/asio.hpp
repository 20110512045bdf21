// Asio and Beast headers that all files with sockets share.
#pragma once

#include <utility> // awaitable.hpp of Boost 1.74 uses std::exchange and does not include <utility>

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

namespace server::gateway {

namespace asio = boost::asio;
namespace beast = boost::beast;
using boost::system::error_code;

// Runs `work` on a thread of `workers`, and resumes on the coroutine's executor. JSON-RPC methods must not run on
// socket threads, because they may take long.
template <typename Work>
asio::awaitable<std::string> on_worker(asio::thread_pool& workers, Work work) {
    auto task = [&work]() -> asio::awaitable<std::string> { co_return work(); };
    co_return co_await asio::co_spawn(workers, std::move(task), asio::use_awaitable);
}

} // namespace server::gateway
