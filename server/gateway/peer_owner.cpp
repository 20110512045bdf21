#include "gateway/peer_owner.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <fstream>
#include <unistd.h>
#include <vector>

namespace server::gateway {
namespace {

constexpr unsigned established = 1;
constexpr std::uint32_t nobody = 65534;

std::string_view take_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    const auto word = line.substr(0, line.find(' '));
    line.remove_prefix(word.size());
    return word;
}

template <typename Number>
bool parse(std::string_view word, Number& number, int base) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number, base);
    return error == std::errc() && end == word.data() + word.size();
}

std::string hex(std::uint32_t number, int digits) {
    std::string text;
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) text += "0123456789ABCDEF"[(number >> shift) & 15];
    return text;
}

asio::ip::address plain_v4(const asio::ip::address& address) {
    if (address.is_v6() && address.to_v6().is_v4_mapped())
        return asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6());
    return address;
}

asio::ip::address mapped(const asio::ip::address& v4) {
    return asio::ip::make_address_v6(asio::ip::v4_mapped, v4.to_v4());
}

} // namespace

std::optional<SocketRow> parse_socket_row(std::string_view line) {
    SocketRow row;
    const auto number = take_word(line);
    if (!number.ends_with(':')) return std::nullopt;
    row.local = take_word(line);
    row.remote = take_word(line);
    const auto state = take_word(line);
    for (int skipped = 0; skipped < 3; ++skipped) take_word(line); // skips queues, timer, retransmissions
    const auto user = take_word(line);
    take_word(line); // skips the timeout
    if (!parse(state, row.state, 16) || !parse(user, row.user, 10) || !parse(take_word(line), row.inode, 10))
        return std::nullopt;
    return row;
}

std::string socket_name(const asio::ip::address& address, unsigned short port) {
    std::array<unsigned char, 16> bytes{};
    std::size_t count = 0;
    const auto copy = [&](const auto& of) {
        std::copy(of.begin(), of.end(), bytes.begin());
        count = of.size();
    };
    address.is_v4() ? copy(address.to_v4().to_bytes()) : copy(address.to_v6().to_bytes());
    std::string name;
    for (std::size_t i = 0; i < count; i += sizeof(std::uint32_t)) {
        std::uint32_t word = 0;
        std::memcpy(&word, &bytes[i], sizeof word);
        name += hex(word, 8);
    }
    return name + ":" + hex(port, 4);
}

std::set<std::string> sockets_of(std::istream& table, std::uint32_t user) {
    std::set<std::string> sockets;
    if (user == nobody) return sockets;
    for (std::string line; std::getline(table, line);) {
        const auto row = parse_socket_row(line);
        if (row && row->state == established && row->inode != 0 && row->user == user)
            sockets.insert(std::string(row->local) + " " + std::string(row->remote));
    }
    return sockets;
}

OwnSockets::OwnSockets() : open_([](const char* path) { return std::make_unique<std::ifstream>(path); }) {}

bool OwnSockets::lists(Table& table, const std::string& socket, Clock::time_point asked) {
    if (table.begun < asked) {
        table.begun = Clock::now();
        table.sockets = sockets_of(*open_(table.path), ::geteuid());
    }
    return table.sockets.contains(socket);
}

bool OwnSockets::contain(const asio::ip::tcp::endpoint& peer, const asio::ip::tcp::endpoint& own,
                         Clock::time_point asked) {
    const auto from = plain_v4(peer.address()), to = plain_v4(own.address());
    const auto socket = [&](const asio::ip::address& at, const asio::ip::address& end) {
        return socket_name(at, peer.port()) + " " + socket_name(end, own.port());
    };
    if (from.is_v6() || to.is_v6()) return lists(v6_, socket(from, to), asked);
    // A client that connects to ::ffff:127.0.0.1 has an IPv6 socket, which only the IPv6 table lists.
    return lists(v4_, socket(from, to), asked) || lists(v6_, socket(mapped(from), mapped(to)), asked);
}

asio::awaitable<bool> PeerOwners::is_own_user(asio::ip::tcp::endpoint peer, asio::ip::tcp::endpoint own) {
    bool is_own = false;
    const auto asked = OwnSockets::Clock::now();
    co_await on_worker(reader_, [&] {
        is_own = sockets_.contain(peer, own, asked);
        return std::string();
    });
    co_return is_own;
}

} // namespace server::gateway
