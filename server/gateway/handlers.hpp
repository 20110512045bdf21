// Handlers of the routes in routes.cpp. POST /rpc has no handler here, because rpc_call.hpp answers it.
#pragma once

#include "gateway/context.hpp"
#include "gateway/http_message.hpp"
#include "gateway/target.hpp"

namespace ciel::gateway {

[[nodiscard]] Response websocket_expected(Context& context, const Request& request, const Target& target);
[[nodiscard]] Response healthz(Context& context, const Request& request, const Target& target);
[[nodiscard]] Response readyz(Context& context, const Request& request, const Target& target);
[[nodiscard]] Response metrics(Context& context, const Request& request, const Target& target);
[[nodiscard]] Response static_file(Context& context, const Request& request, const Target& target);

// Adds the security headers to a response, and the CORS headers if the request's origin is one of AccessRules::origins.
void add_common_headers(const Context& context, const Request& request, Response& response);

} // namespace ciel::gateway
