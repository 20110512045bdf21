// Whose process is at the other end of a connection inside this machine: Linux lists sockets with their owners in
// /proc/net/tcp and /proc/net/tcp6 (proc(5)).
#pragma once

#include "gateway/asio.hpp"

#include <cstdint>
#include <iosfwd>
#include <optional>
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

// Whether a table has an established socket of `user`, held by a process, from `peer` to `own` (names of sockets).
[[nodiscard]] bool lists_socket_of(std::istream& table, std::string_view peer, std::string_view own,
                                   std::uint32_t user);

// Whether a process of this process's user holds the peer's end. The user 65534 (nobody) never does: a user namespace
// shows everybody from outside by that number. Reads files of the kernel; not for the threads of the sockets.
[[nodiscard]] bool is_own_user(const asio::ip::tcp::endpoint& peer, const asio::ip::tcp::endpoint& own);

} // namespace ciel::gateway
