#include "gateway/access.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <sys/random.h>

namespace ciel::gateway {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_ignoring_case(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

bool listed(const std::vector<std::string>& names, std::string_view name) {
    return std::any_of(names.begin(), names.end(), [&](const auto& other) { return same_ignoring_case(other, name); });
}

std::string_view without_port(std::string_view host) {
    const auto end_of_address = host.starts_with('[') ? host.find(']') : 0; // an IPv6 address holds colons itself
    return host.substr(0, host.find(':', end_of_address));
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

// Calls visit with each part until one returns true.
template <typename Visit>
bool any_part(std::string_view text, char separator, const Visit& visit) {
    while (!text.empty()) {
        const auto part = text.substr(0, text.find(separator));
        if (visit(trimmed(part))) return true;
        text.remove_prefix(std::min(part.size() + 1, text.size()));
    }
    return false;
}

// 127.0.0.0/8: no page of another site can be reached by such a name.
bool is_loopback_address(std::string_view name) {
    return name.starts_with("127.") && name.find_first_not_of("0123456789.") == std::string_view::npos;
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
    static const std::vector<std::string> local{"localhost", "[::1]"};
    return listed(local, name) || is_loopback_address(name);
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
    return rules.token.empty() || same_in_constant_time(presented, rules.token);
}

bool carries_token(const AccessRules& rules, const Request& request, const Target& target) {
    return !rules.token.empty() && same_in_constant_time(presented_token(rules, request, target), rules.token);
}

std::string cookie_value(std::string_view header, std::string_view name) {
    std::string value;
    any_part(header, ';', [&](std::string_view part) {
        const auto equals = part.find('=');
        if (equals == std::string_view::npos || part.substr(0, equals) != name) return false;
        value = part.substr(equals + 1);
        return true;
    });
    return value;
}

std::string token_cookie(const AccessRules& rules, bool secure) {
    return rules.cookie_name + "=" + rules.token + "; Path=" + rules.cookie_path + "; HttpOnly; SameSite=Strict" +
           (secure ? "; Secure" : "");
}

bool offers_subprotocol(std::string_view header) {
    return any_part(header, ',', [](std::string_view part) { return part == subprotocol; });
}

std::string generate_token() {
    std::array<unsigned char, 16> bytes{};
    if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw Error(std::string("no random bytes for a token (") + std::strerror(errno) + "); name one with --token");
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
        throw Error("a token needs at least 8 characters, letters, digits and -._~ only");
}

} // namespace ciel::gateway
