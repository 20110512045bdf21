// HTTP and WebSocket server with Boost.Beast. No other folder uses Boost.
#pragma once

#include "gateway/service.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace server::gateway {

struct GatewayOptions {
    std::string host = "127.0.0.1";
    unsigned short port = 8080;      // 0: any free port
    std::string prefix;              // such as "/ciel" behind a proxy; the proxy may strip the prefix
    std::filesystem::path webclient; // folder of the static files; empty: no web client
    // If this is empty, a token is generated, and on loopback the server's own user needs no token.
    std::string token;
    std::vector<std::string> origins;       // such as "https://example.org"; the server's own origin is always allowed
    std::vector<std::string> allowed_hosts; // names accepted in Host, in addition to local names
    // Addresses or ranges such as "172.30.0.0/16". X-Forwarded-For is used only from these proxies.
    std::vector<std::string> trusted_proxies;
    unsigned threads = 2; // threads that read and write sockets
    unsigned workers = 8; // threads for quick methods; slow methods run on other threads (Limits::slow_calls)
    std::string version;  // for the Server header
};

struct Listening {
    std::string host; // in URL form: "127.0.0.1", "[::1]"
    unsigned short port = 0;
    std::string prefix; // normalized: such as "/ciel", or empty
    std::string token;  // the given or generated token
};

// Returns 128 random bits as 32 hexadecimal digits. Throws Error when the system gives no random bytes.
[[nodiscard]] std::string generate_token();

// Serves until SIGINT or SIGTERM, then drains. A second signal ends the process at once. Returns the exit code. Throws
// Error if the address cannot be bound, the token is malformed, or the web client's folder is unreadable. Calls
// `on_listening` before it accepts the first connection.
// While draining, calls have half of Limits::drain_seconds to finish. Then they are cancelled, and WebSockets close
// with code 1001 without waiting for answers. At the end, clients that do not read are disconnected.
int serve(Service& service, const GatewayOptions& options, const std::function<void(const Listening&)>& on_listening);

} // namespace server::gateway
