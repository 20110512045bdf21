#include "gateway/remote_address.hpp"

#include "ciel/types.hpp"
#include "gateway/header_text.hpp"

#include <algorithm>

namespace server::gateway {
namespace {

namespace ip = asio::ip;

constexpr unsigned short counted_bits = 64;

std::string_view without_port(std::string_view text) {
    if (text.starts_with('['))
        return text.find(']') == std::string_view::npos ? std::string_view() : text.substr(1, text.find(']') - 1);
    const auto colon = text.find(':');
    return colon != std::string_view::npos && text.find(':', colon + 1) == std::string_view::npos
               ? text.substr(0, colon)
               : text;
}

} // namespace

TrustedProxies::TrustedProxies(const std::vector<std::string>& ranges) {
    for (const auto& range : ranges) {
        const bool is_single = range.find('/') == std::string::npos;
        error_code error;
        if (range.find(':') != std::string::npos)
            v6_.push_back(ip::make_network_v6(is_single ? range + "/128" : range, error));
        else
            v4_.push_back(ip::make_network_v4(is_single ? range + "/32" : range, error));
        if (error)
            throw ciel::Error(
                range + " is not an IP address or a range of addresses; give one such as 10.0.0.7 or 172.30.0.0/16");
    }
}

bool TrustedProxies::contains(const ip::address& address) const {
    const ip::address plain = without_mapping(address);
    if (plain.is_v4())
        return std::any_of(v4_.begin(), v4_.end(), [&](const auto& range) {
            return ip::network_v4(plain.to_v4(), range.prefix_length()).network() == range.network();
        });
    return std::any_of(v6_.begin(), v6_.end(), [&](const auto& range) {
        return ip::network_v6(plain.to_v6(), range.prefix_length()).network() == range.network();
    });
}

std::optional<ip::address> last_forwarded_for(std::string_view header) {
    const auto comma = header.rfind(',');
    const auto last = trimmed(header.substr(comma == std::string_view::npos ? 0 : comma + 1));
    error_code error;
    const auto address = ip::make_address(std::string(without_port(last)), error);
    return error ? std::nullopt : std::optional(without_mapping(address));
}

std::string counting_key(const ip::address& address) {
    const ip::address plain = without_mapping(address);
    if (plain.is_loopback()) return {};
    if (plain.is_v4()) return plain.to_string();
    ip::address_v6 v6 = plain.to_v6();
    v6.scope_id(0);
    return ip::network_v6(v6, counted_bits).canonical().to_string();
}

std::string logged_address(const std::string& address) {
    boost::system::error_code error;
    const ip::address parsed = ip::make_address(address, error);
    std::string key = error ? std::string() : counting_key(parsed);
    return key.empty() ? address : key;
}

ip::address without_mapping(const ip::address& address) {
    return address.is_v6() && address.to_v6().is_v4_mapped() ? ip::make_address_v4(ip::v4_mapped, address.to_v6())
                                                             : address;
}

} // namespace server::gateway
