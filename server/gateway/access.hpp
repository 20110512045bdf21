// Who may call: the Host header (DNS rebinding), the Origin header (other sites' pages), the token, the user of the
// process at the other end.
#pragma once

#include "gateway/gateway.hpp"
#include "gateway/http_message.hpp"
#include "gateway/target.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ciel::gateway {

struct AccessRules {
    bool loopback = true; // bound to the loopback interface: only local names may be in Host
    std::vector<std::string> allowed_hosts;
    std::vector<std::string> origins; // "https://example.org", beside the server's own
    std::string token;
    bool own_user_enters = false; // a process of the server's user needs no token
    std::string cookie_name;      // names the port, since browsers share cookies between a host's ports
    std::string cookie_path = "/";
};

// On loopback the name must be localhost, a loopback address or one of allowed_hosts, whatever the port; elsewhere only
// when allowed_hosts is not empty. A request without Host comes from no browser and passes.
[[nodiscard]] bool host_allowed(const AccessRules& rules, std::string_view host);

// No Origin (a script) passes; a browser's must be the server's own (same host and port as Host) or listed.
[[nodiscard]] bool origin_allowed(const AccessRules& rules, std::string_view origin, std::string_view host);

// Where a token stands: Authorization: Bearer, ?token=, the cookie, in this order; empty when nowhere.
[[nodiscard]] std::string presented_token(const AccessRules& rules, const Request& request, const Target& target);
[[nodiscard]] bool token_allowed(const AccessRules& rules, std::string_view presented); // in constant time

enum class Claim { token, own_user, wrong_token, none };
// What a request brings to be let in. A request that came through a proxy, or under a name that is not local, is not
// its user's own: a proxy lets the world in.
[[nodiscard]] Claim claim_of(const AccessRules& rules, const Request& request, const Target& target);
[[nodiscard]] inline bool is_let_in(Claim claim) { return claim == Claim::token || claim == Claim::own_user; }

// Whether a header of this name says that a proxy passed the request on: Forwarded (RFC 7239), Via, X-Forwarded-*,
// X-Real-IP.
[[nodiscard]] bool is_of_a_proxy(std::string_view header_name);

// The value of a cookie in a Cookie header (RFC 6265); empty when it is not there.
[[nodiscard]] std::string cookie_value(std::string_view header, std::string_view name);
// Set-Cookie for the browser that came with ?token=. Secure when the proxy in front speaks TLS.
[[nodiscard]] std::string token_cookie(const AccessRules& rules, bool secure);

// Whether Sec-WebSocket-Protocol, its lines joined by commas, offers "ciel.v1".
inline constexpr std::string_view subprotocol = "ciel.v1";
[[nodiscard]] bool offers_subprotocol(std::string_view header);

// Whether Sec-WebSocket-Key is 16 bytes in base64 (RFC 6455, 4.2.1).
[[nodiscard]] bool is_handshake_key(std::string_view header);

// Throws Error unless it is at least 8 of the characters that need no quoting in a URL, a header and a cookie.
void check_token_form(const std::string& token);

} // namespace ciel::gateway
