// Finds the user whose process is the client of a connection within this machine. Linux lists sockets with their owners
// in /proc/net/tcp and /proc/net/tcp6 (proc(5)).
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

namespace server::gateway {

struct SocketRow {
    std::string_view local, remote; // in the form of socket_name()
    unsigned state = 0;             // 1: established
    std::uint32_t user = 0;
    std::uint64_t inode = 0; // 0: no process holds the socket, and `user` is meaningless
};

// Parses one line of /proc/net/tcp. Returns nothing for the heading and malformed lines. The views point into `line`.
[[nodiscard]] std::optional<SocketRow> parse_socket_row(std::string_view line);

// Returns "0100007F:1F90" for 127.0.0.1:8080 on a little-endian machine: words of 32 bits in native byte order.
[[nodiscard]] std::string socket_name(const asio::ip::address& address, unsigned short port);

// Returns "LOCAL REMOTE" for each established socket that a process of `user` holds. Returns nothing for user 65534
// (nobody). In a container, all users outside the container have this number.
[[nodiscard]] std::set<std::string> sockets_of(std::istream& table, std::uint32_t user);

// The established sockets of this process's user. Not thread-safe.
class OwnSockets {
public:
    using Clock = std::chrono::steady_clock;
    using Open = std::function<std::unique_ptr<std::istream>(const char* path)>;

    OwnSockets(); // reads the tables in /proc/net
    explicit OwnSockets(Open open) : open_(std::move(open)) {}

    // Returns whether the client's end of a connection is such a socket. Reading a table takes milliseconds, so a table
    // is read again only if its last reading began before `asked`. `own`: the server's end.
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

// Finds out whether the client of a local connection is a process of the server's user. Reads the tables in /proc/net
// on a separate thread, because reading them takes long if the machine has thousands of connections.
class PeerOwners {
public:
    // Await this on the connection's executor.
    [[nodiscard]] asio::awaitable<bool> is_own_user(asio::ip::tcp::endpoint peer, asio::ip::tcp::endpoint own);
    void join() { reader_.join(); } // call after the last is_own_user()

private:
    asio::thread_pool reader_{1};
    OwnSockets sockets_; // used on the thread of reader_ only
};

} // namespace server::gateway
