// Handlers of the routes in routes.cpp. POST /rpc has no handler here, because rpc_call.hpp answers it.
#pragma once

#include "gateway/gateway_state.hpp"
#include "gateway/http_message.hpp"
#include "gateway/target.hpp"

namespace server::gateway {

[[nodiscard]] Response websocket_expected(GatewayState& state, const Request& request, const Target& target);
[[nodiscard]] Response healthz(GatewayState& state, const Request& request, const Target& target);
[[nodiscard]] Response readyz(GatewayState& state, const Request& request, const Target& target);
[[nodiscard]] Response metrics(GatewayState& state, const Request& request, const Target& target);
[[nodiscard]] Response static_file(GatewayState& state, const Request& request, const Target& target);

// Adds the security headers to a response, and the CORS headers if the request's origin is one of AccessRules::origins.
void add_common_headers(const GatewayState& state, const Request& request, Response& response);

} // namespace server::gateway
