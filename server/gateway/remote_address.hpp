// The address under which the connections of a client are counted: the address of the peer, or the address that a
// trusted proxy forwards.
#pragma once

#include "gateway/asio.hpp"

#include <boost/asio/ip/network_v4.hpp>
#include <boost/asio/ip/network_v6.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace server::gateway {

// Addresses of proxies whose X-Forwarded-For is used.
class TrustedProxies {
public:
    // `ranges`: such as "10.0.0.7", "172.30.0.0/16", "fd00::/8". Throws Error if a range is malformed.
    explicit TrustedProxies(const std::vector<std::string>& ranges);
    [[nodiscard]] bool contains(const asio::ip::address& address) const;

private:
    std::vector<asio::ip::network_v4> v4_;
    std::vector<asio::ip::network_v6> v6_;
};

// Returns the last address of X-Forwarded-For, without a port and brackets. The nearest proxy has written this address.
// Returns nothing if the last element is not an address.
[[nodiscard]] std::optional<asio::ip::address> last_forwarded_for(std::string_view header);

// Returns the text under which connections of an address are counted. The key of a loopback address is empty, because
// loopback has no limit. The key of an IPv6 address has its first 64 bits, because a host may choose the other bits.
[[nodiscard]] std::string counting_key(const asio::ip::address& address);

// Returns the counting_key() of an address in text form, or the address itself if its key is empty.
[[nodiscard]] std::string logged_address(const std::string& address);

// Converts an IPv4-mapped IPv6 address (::ffff:0:0/96) to IPv4. Returns other addresses unchanged.
[[nodiscard]] asio::ip::address without_mapping(const asio::ip::address& address);

} // namespace server::gateway
