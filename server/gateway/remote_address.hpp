// The address for which a connection is counted: the peer's, or the one that a trusted proxy forwards.
#pragma once

#include "gateway/asio.hpp"

#include <boost/asio/ip/network_v4.hpp>
#include <boost/asio/ip/network_v6.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::gateway {

// Addresses of proxies whose X-Forwarded-For is used.
class TrustedProxies {
public:
    // `ranges`: "10.0.0.7", "172.30.0.0/16", "fd00::/8". Throws Error when one is malformed.
    explicit TrustedProxies(const std::vector<std::string>& ranges);
    [[nodiscard]] bool contains(const asio::ip::address& address) const;

private:
    std::vector<asio::ip::network_v4> v4_;
    std::vector<asio::ip::network_v6> v6_;
};

// Returns the last element of X-Forwarded-For, written by the nearest proxy; nothing if it is not an address. A port is
// removed; IPv6 may be in brackets.
[[nodiscard]] std::optional<asio::ip::address> last_forwarded_for(std::string_view header);

// Returns the key by which connections of this address are counted; empty for loopback, which is not counted.
// IPv6 is counted by its first 64 bits: a host may choose the others.
[[nodiscard]] std::string counting_key(const asio::ip::address& address);

// Converts IPv4-mapped IPv6 (::ffff:0:0/96) to IPv4.
[[nodiscard]] asio::ip::address without_mapping(const asio::ip::address& address);

} // namespace ciel::gateway
