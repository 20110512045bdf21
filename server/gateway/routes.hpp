// The table of routes, and the checks before a handler runs.
#pragma once

#include "gateway/gateway_state.hpp"
#include "gateway/http_message.hpp"
#include "gateway/target.hpp"

#include <optional>
#include <span>

namespace server::gateway {

using Handler = Response (*)(GatewayState& state, const Request& request, const Target& target);

struct Route {
    std::string_view path;
    std::string_view method; // GET includes HEAD
    bool needs_token;        // false for the web client's files, /healthz and /readyz, which show no data
    enum class Kind { quick, probe, rpc, websocket } kind;
    Handler handler; // null for rpc, which rpc_call.hpp answers
};

[[nodiscard]] std::span<const Route> routes();

struct Resolved {
    std::optional<Response> refusal; // if set, this is the answer, and `route` is null
    const Route* route = nullptr;
    Target target;
    Claim claim = Claim::none;
};

// Checks everything except the body: target, Host, method, Origin, token, content type.
[[nodiscard]] Resolved resolve(const GatewayState& state, const Request& request);

// Adds the common headers. If the handler throws, the answer has status 500.
[[nodiscard]] Response respond(GatewayState& state, const Request& request, const Resolved& resolved);

} // namespace server::gateway
