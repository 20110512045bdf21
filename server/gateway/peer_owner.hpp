// Whose process is at the other end of a connection inside this machine: Linux lists sockets with their owners in
// /proc/net/tcp and /proc/net/tcp6 (proc(5)).
#pragma once

#include "gateway/asio.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace ciel::gateway {

struct SocketRow {
    std::string_view local, remote; // as socket_name() writes them
    unsigned state = 0;             // 1: established
    std::uint32_t user = 0;
    std::uint64_t inode = 0; // 0: no process has the socket any more, and `user` says nothing
};

// One line of such a table; nothing for its heading and for what is no row. The views point into `line`.
[[nodiscard]] std::optional<SocketRow> parse_socket_row(std::string_view line);

// "0100007F:1F90" for 127.0.0.1:8080 on a little-endian machine: 32-bit words in its own byte order.
[[nodiscard]] std::string socket_name(const asio::ip::address& address, unsigned short port);

// "LOCAL REMOTE" of the table's established sockets that a process of `user` holds. The user 65534 (nobody) holds none:
// a user namespace shows everybody from outside by that number.
[[nodiscard]] std::set<std::string> sockets_of(std::istream& table, std::uint32_t user);

// The sockets of this process's user. Not thread-safe.
class OwnSockets {
public:
    using Clock = std::chrono::steady_clock;
    using Open = std::function<std::unique_ptr<std::istream>(const char* path)>;

    OwnSockets(); // of the kernel's tables
    explicit OwnSockets(Open open) : open_(std::move(open)) {}

    // Whether one goes from `peer` to `own`. Takes milliseconds where a table is read anew: only where the last reading
    // began before `asked`, so that one answers all who wait for it.
    [[nodiscard]] bool contain(const asio::ip::tcp::endpoint& peer, const asio::ip::tcp::endpoint& own,
                               Clock::time_point asked);

private:
    struct Table {
        const char* path;
        Clock::time_point begun = Clock::time_point::min();
        std::set<std::string> sockets = {};
    };
    [[nodiscard]] bool lists(Table& table, const std::string& socket, Clock::time_point asked);

    Open open_;
    Table v4_{"/proc/net/tcp"}, v6_{"/proc/net/tcp6"};
};

// Reads the tables on a thread of its own: the methods' threads are not to wait for thousands of connections.
class PeerOwners {
public:
    // Whether a process of this process's user holds the peer's end. To be awaited on the connection's executor.
    [[nodiscard]] asio::awaitable<bool> is_own_user(asio::ip::tcp::endpoint peer, asio::ip::tcp::endpoint own);
    void join() { reader_.join(); } // after the last question

private:
    asio::thread_pool reader_{1};
    OwnSockets sockets_; // of that thread
};

} // namespace ciel::gateway
