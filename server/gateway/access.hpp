// Access checks: Host header (against DNS rebinding), Origin header (against other sites), token, operating system's
// user of a local client.
#pragma once

#include "gateway/gateway.hpp"
#include "gateway/http_message.hpp"
#include "gateway/target.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace server::gateway {

struct AccessRules {
    bool loopback = true; // if true, Host must be a local name or one of allowed_hosts
    std::vector<std::string> allowed_hosts;
    std::vector<std::string> origins; // such as "https://example.org"; the server's own origin is always allowed
    std::string token;
    bool own_user_enters = false; // whether local processes of the server's user need no token
    std::string cookie_name;      // contains the port, because browsers share cookies between the ports of a host
    std::string cookie_path = "/";
};

// On loopback, Host must be a local name or one of allowed_hosts, with any port. On other interfaces it is checked only
// if allowed_hosts is not empty. A request without Host is accepted, because browsers always send Host.
[[nodiscard]] bool host_allowed(const AccessRules& rules, std::string_view host);

// Accepts an absent Origin (as in requests of scripts), the server's own origin, and rules.origins.
[[nodiscard]] bool origin_allowed(const AccessRules& rules, std::string_view origin, std::string_view host);

// Returns the token of `Authorization: Bearer`, else of `?token=`, else of the cookie; empty if the request has none.
[[nodiscard]] std::string presented_token(const AccessRules& rules, const Request& request, const Target& target);
[[nodiscard]] bool token_allowed(const AccessRules& rules, std::string_view presented); // compares in constant time

enum class Claim { token, own_user, wrong_token, none };
// Returns own_user only if Host is a local name and the request is not proxied. A proxy forwards requests of any user.
[[nodiscard]] Claim claim_of(const AccessRules& rules, const Request& request, const Target& target);
[[nodiscard]] inline bool is_let_in(Claim claim) { return claim == Claim::token || claim == Claim::own_user; }

// Returns whether proxies add a header of this name: Forwarded (RFC 7239), Via, X-Forwarded-*, X-Real-IP.
[[nodiscard]] bool is_of_a_proxy(std::string_view header_name);

// Returns the value of a cookie in a Cookie header (RFC 6265); empty if absent.
[[nodiscard]] std::string cookie_value(std::string_view header, std::string_view name);
// Returns the Set-Cookie value that stores the token in a browser. `secure`: whether the proxy in front uses TLS.
[[nodiscard]] std::string token_cookie(const AccessRules& rules, bool secure);

inline constexpr std::string_view subprotocol = "ciel.v1";
// `header`: all lines of the header Sec-WebSocket-Protocol, joined by commas.
[[nodiscard]] bool offers_subprotocol(std::string_view header);

// Returns whether Sec-WebSocket-Key is 16 bytes in base64 (RFC 6455, 4.2.1).
[[nodiscard]] bool is_handshake_key(std::string_view header);

// Throws Error unless the token has at least 8 characters, all valid without quoting in a URL, a header and a cookie.
void check_token_form(const std::string& token);

} // namespace server::gateway
