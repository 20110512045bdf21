// HTTP and WebSocket by Boost.Beast. The only folder that knows it.
#pragma once

#include "gateway/service.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ciel::gateway {

struct GatewayOptions {
    std::string host = "127.0.0.1";
    unsigned short port = 8080;               // 0: any free one
    std::string prefix;                       // "/ciel" behind a proxy, whether it keeps the path or not
    std::filesystem::path webclient;          // static files; empty: none
    std::string token;                        // needed by everybody; empty: one is made, and on loopback the server's
                                              // own user needs none
    std::vector<std::string> origins;         // "https://example.org", allowed beside the server's own
    std::vector<std::string> allowed_hosts;   // names in Host, beside localhost when bound to loopback
    std::vector<std::string> trusted_proxies; // addresses, or ranges "172.30.0.0/16": their X-Forwarded-For is believed
    unsigned threads = 2;                     // for sockets
    unsigned workers = 8; // for quick methods; slow ones have threads of their own (Limits::slow_calls)
    std::string version;  // for the Server header
};

// What the log and the address on the console need.
struct Listening {
    std::string host; // as it stands in a URL: "127.0.0.1", "[::1]"
    unsigned short port = 0;
    std::string prefix; // normalised: empty or "/ciel"
    std::string token;  // the one given, or made
};

// 128 random bits as a token that needs no quoting anywhere.
[[nodiscard]] std::string generate_token();

// Serves until SIGINT or SIGTERM, then drains: no new connections, clients are told, WebSockets close with 1001. What
// is under way has half of Limits::drain_seconds to finish; then calls are given up, WebSockets closed though answers
// are missing, and clients that do not read, or do not close in turn, are cut off. A second signal ends the process at
// once. on_listening is called from the thread that called serve, before anything is served. Throws Error when the
// address cannot be bound, the token is badly formed, or the web client's folder cannot be read. Returns the process's
// exit code.
int serve(Service& service, const GatewayOptions& options, const std::function<void(const Listening&)>& on_listening);

} // namespace ciel::gateway
