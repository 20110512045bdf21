// HTTP and WebSocket server with Boost.Beast. No other folder uses Boost.
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
    std::string prefix;                       // "/ciel" behind a proxy, whether the proxy strips it or not
    std::filesystem::path webclient;          // static files; empty: none
    std::string token;                        // required of every client; empty: generated, and on loopback the
                                              // server's own user needs none
    std::vector<std::string> origins;         // "https://example.org", in addition to the server's own
    std::vector<std::string> allowed_hosts;   // names accepted in Host, in addition to local names
    std::vector<std::string> trusted_proxies; // addresses or ranges "172.30.0.0/16" whose X-Forwarded-For is used
    unsigned threads = 2;                     // threads that read and write sockets
    unsigned workers = 8; // threads for quick methods; slow methods run on other threads (Limits::slow_calls)
    std::string version;  // for the Server header
};

// The bound address, for the log and the console.
struct Listening {
    std::string host; // in URL form: "127.0.0.1", "[::1]"
    unsigned short port = 0;
    std::string prefix; // normalized: empty or "/ciel"
    std::string token;  // the given or generated one
};

// Returns 128 random bits as 32 hexadecimal digits. Throws Error when the system gives no random bytes.
[[nodiscard]] std::string generate_token();

// Serves until SIGINT or SIGTERM, then drains; a second signal ends the process at once. Returns the exit code of the
// process. Throws Error when the address cannot be bound, the token is malformed, or the web client's folder is
// unreadable. on_listening is called on the caller's thread before the first connection is accepted.
// Draining refuses new connections, notifies clients, and closes WebSockets with 1001. Calls have half of
// Limits::drain_seconds to finish. Then they are cancelled, and WebSockets close without waiting for answers. In the
// end, clients that do not read or do not answer the close are disconnected.
int serve(Service& service, const GatewayOptions& options, const std::function<void(const Listening&)>& on_listening);

} // namespace ciel::gateway
