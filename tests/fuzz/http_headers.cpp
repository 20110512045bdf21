// Fuzzes the headers for access and framing, one per line: Host, Origin, Authorization, Cookie, Sec-WebSocket-Protocol,
// Transfer-Encoding, Accept-Encoding, Sec-WebSocket-Key.
#include "gateway/access.hpp"
#include "gateway/framing.hpp"
#include "gateway/static_files.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

using namespace server::gateway;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view rest(reinterpret_cast<const char*>(data), size);
    std::array<std::string, 8> lines;
    for (auto& line : lines) {
        line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    }
    AccessRules rules;
    rules.token = "0123456789abcdef";
    rules.cookie_name = "ciel_token_80";
    Request request;
    request.authorization = lines[2];
    request.cookie = lines[3];
    const std::string token = presented_token(rules, request, {"/", {}});
    if (token_allowed(rules, token) && lines[2].find(rules.token) == std::string::npos &&
        lines[3].find(rules.token) == std::string::npos)
        std::abort();
    if (host_allowed(rules, lines[0]) && lines[0].find("evil") != std::string::npos &&
        lines[0].find(':') == std::string::npos)
        std::abort();
    if (origin_allowed(rules, lines[1], lines[0]) && !lines[1].empty() && !lines[1].starts_with("http")) std::abort();
    if (offers_subprotocol(lines[4]) && lines[4].find(subprotocol) == std::string::npos) std::abort();
    if (framing_of(lines[5]) == Framing::readable && lines[5].find_first_of(",;") != std::string::npos) std::abort();
    if (accepts_gzip(lines[6]) && lines[6].find_first_of("gG*") == std::string::npos) std::abort();
    if (is_handshake_key(lines[7]) && lines[7].size() != 24) std::abort();
    return 0;
}
