// The table of routes, and what is checked before one is taken.
#pragma once

#include "gateway/context.hpp"
#include "gateway/http_message.hpp"
#include "gateway/target.hpp"

#include <optional>
#include <span>

namespace ciel::gateway {

using Handler = Response (*)(Context& context, const Request& request, const Target& target);

struct Route {
    std::string_view path;
    std::string_view method; // GET stands for HEAD too
    bool needs_token;        // the web client's files and the probes are no secret: they hold no data
    enum class Kind { quick, on_worker, rpc, websocket } kind;
    Handler handler; // none for rpc: rpc_call.hpp
};

[[nodiscard]] std::span<const Route> routes();

struct Resolved {
    std::optional<Response> refusal; // when set, the answer; `route` is null
    const Route* route = nullptr;
    Target target;
    Claim claim = Claim::none;
};

// Looks at everything but the body: target, Host, method, Origin, token, content type.
[[nodiscard]] Resolved resolve(const Context& context, const Request& request);

// Calls the route's handler, turns exceptions into a 500, and adds the headers that every answer carries.
[[nodiscard]] Response respond(Context& context, const Request& request, const Resolved& resolved);

} // namespace ciel::gateway
