// Whom a connection is counted for: the peer, or what a proxy that is trusted says of its own peer.
#pragma once

#include "gateway/asio.hpp"

#include <boost/asio/ip/network_v4.hpp>
#include <boost/asio/ip/network_v6.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::gateway {

// The addresses of proxies whose X-Forwarded-For is believed.
class TrustedProxies {
public:
    // "10.0.0.7", "172.30.0.0/16", "fd00::/8". Throws Error with a sentence.
    explicit TrustedProxies(const std::vector<std::string>& ranges);
    [[nodiscard]] bool contains(const asio::ip::address& address) const;

private:
    std::vector<asio::ip::network_v4> v4_;
    std::vector<asio::ip::network_v6> v6_;
};

// The last element of X-Forwarded-For, which the nearest proxy has written: an address, perhaps with a port, IPv6 in
// brackets or not. Nothing where it is none.
[[nodiscard]] std::optional<asio::ip::address> last_forwarded_for(std::string_view header);

// What stands for this address in a count: IPv6 by its first 64 bits, since a host may choose the others. Empty for
// loopback, which is not counted.
[[nodiscard]] std::string counting_key(const asio::ip::address& address);

// IPv4 out of ::ffff:0:0/96.
[[nodiscard]] asio::ip::address without_mapping(const asio::ip::address& address);

} // namespace ciel::gateway
