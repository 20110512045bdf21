// HTTP and WebSocket by Boost.Beast. The only folder that knows it.
#pragma once

#include "session/server.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ciel::gateway {

struct GatewayOptions {
    std::string host = "127.0.0.1";
    unsigned short port = 8080;       // 0: any free one
    std::string prefix;               // "/ciel" behind a proxy that keeps the path
    std::filesystem::path webclient;  // static files
    std::string token;                // empty on loopback; required elsewhere
    std::vector<std::string> origins; // allowed beside the server's own
    unsigned threads = 2;
};

// Serves until SIGINT or SIGTERM, then drains. on_listening gets the bound port. Throws Error when the address cannot
// be bound. Returns the process's exit code.
int serve(session::Server& server, const GatewayOptions& options,
          const std::function<void(unsigned short port)>& on_listening);

} // namespace ciel::gateway
