#include "gateway/access.hpp"

#include "ciel/types.hpp"
#include "gateway/header_text.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <sys/random.h>

namespace server::gateway {
namespace {

bool listed(const std::vector<std::string>& names, std::string_view name) {
    return std::any_of(names.begin(), names.end(), [&](const auto& other) { return same_ignoring_case(other, name); });
}

std::string_view without_port(std::string_view host) {
    const auto end_of_address = host.starts_with('[') ? host.find(']') : 0; // skips the colons of [IPv6]
    const auto colon = host.find(':', end_of_address);
    const bool has_port =
        colon != std::string_view::npos && host.find_first_not_of("0123456789", colon + 1) == std::string_view::npos;
    return has_port ? host.substr(0, colon) : host;
}

// A loopback address in Host rules out DNS rebinding: there the browser sends the host name of the attacking site.
bool is_loopback_address(std::string_view name) {
    return name.starts_with("127.") && name.find_first_not_of("0123456789.") == std::string_view::npos;
}

bool is_local_name(std::string_view name) {
    return same_ignoring_case(name, "localhost") || name == "[::1]" || is_loopback_address(name);
}

bool same_in_constant_time(std::string_view a, std::string_view b) {
    unsigned difference = a.size() == b.size() ? 0 : 1;
    for (std::size_t i = 0; i < a.size(); ++i)
        difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b.empty() ? 0 : b[i % b.size()]);
    return difference == 0;
}

} // namespace

bool host_allowed(const AccessRules& rules, std::string_view host) {
    if (host.empty() || (!rules.loopback && rules.allowed_hosts.empty())) return true;
    const auto name = without_port(host);
    if (listed(rules.allowed_hosts, name) || listed(rules.allowed_hosts, host)) return true;
    return is_local_name(name);
}

bool is_of_a_proxy(std::string_view header_name) {
    constexpr std::string_view family = "X-Forwarded-";
    return same_ignoring_case(header_name, "Forwarded") || same_ignoring_case(header_name, "Via") ||
           same_ignoring_case(header_name, "X-Real-IP") ||
           same_ignoring_case(header_name.substr(0, family.size()), family);
}

Claim claim_of(const AccessRules& rules, const Request& request, const Target& target) {
    const std::string presented = presented_token(rules, request, target);
    if (token_allowed(rules, presented)) return Claim::token;
    if (rules.own_user_enters && request.is_of_own_user && !request.is_proxied &&
        is_local_name(without_port(request.host)))
        return Claim::own_user;
    return presented.empty() ? Claim::none : Claim::wrong_token;
}

bool origin_allowed(const AccessRules& rules, std::string_view origin, std::string_view host) {
    if (origin.empty() || listed(rules.origins, origin)) return true;
    for (const std::string_view scheme : {"http://", "https://"})
        if (origin.starts_with(scheme)) return !host.empty() && same_ignoring_case(origin.substr(scheme.size()), host);
    return false;
}

std::string presented_token(const AccessRules& rules, const Request& request, const Target& target) {
    constexpr std::string_view bearer = "Bearer ";
    const std::string_view authorization = request.authorization;
    if (authorization.size() > bearer.size() && same_ignoring_case(authorization.substr(0, bearer.size()), bearer))
        return std::string(trimmed(authorization.substr(bearer.size())));
    if (const auto found = target.query.find("token"); found != target.query.end()) return found->second;
    return cookie_value(request.cookie, rules.cookie_name);
}

bool token_allowed(const AccessRules& rules, std::string_view presented) {
    return !rules.token.empty() && same_in_constant_time(presented, rules.token);
}

std::string cookie_value(std::string_view header, std::string_view name) {
    std::string value;
    any_item(header, ';', [&](std::string_view item) {
        const auto equals = item.find('=');
        if (equals == std::string_view::npos || item.substr(0, equals) != name) return false;
        value = item.substr(equals + 1);
        return true;
    });
    return value;
}

std::string token_cookie(const AccessRules& rules, bool secure) {
    return rules.cookie_name + "=" + rules.token + "; Path=" + rules.cookie_path + "; HttpOnly; SameSite=Strict" +
           (secure ? "; Secure" : "");
}

bool offers_subprotocol(std::string_view header) {
    return any_item(header, ',', [](std::string_view item) { return item == subprotocol; });
}

bool is_handshake_key(std::string_view header) {
    constexpr std::size_t digits = 22; // base64 digits for 16 bytes, without the two padding characters
    const auto is_digit = [](char c) {
        return (lower(c) >= 'a' && lower(c) <= 'z') || (c >= '0' && c <= '9') || c == '+' || c == '/';
    };
    return header.size() == digits + 2 && header.ends_with("==") &&
           std::all_of(header.begin(), header.begin() + digits, is_digit);
}

std::string generate_token() {
    std::array<unsigned char, 16> bytes{};
    if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw ciel::Error(std::string("the system gave no random bytes for a token (") + std::strerror(errno) +
                          "); set the token with --token");
    std::string token;
    for (const auto byte : bytes) {
        token += "0123456789abcdef"[byte >> 4];
        token += "0123456789abcdef"[byte & 15];
    }
    return token;
}

void check_token_form(const std::string& token) {
    const auto allowed = [](char c) {
        return (lower(c) >= 'a' && lower(c) <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '_' ||
               c == '~';
    };
    if (token.size() < 8 || !std::all_of(token.begin(), token.end(), allowed))
        throw ciel::Error("the token is not valid; give at least 8 characters, each a letter, a digit or one of -._~");
}

} // namespace server::gateway
