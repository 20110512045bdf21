#include "gateway/routes.hpp"

#include "gateway/handlers.hpp"
#include "logging/log.hpp"

namespace server::gateway {
namespace {

constexpr std::array<Route, 6> table{{
    // Columns: path, method, needs_token, kind, handler.
    {"/ws", "GET", true, Route::Kind::websocket, websocket_expected},
    {"/rpc", "POST", true, Route::Kind::rpc, nullptr},
    {"/healthz", "GET", false, Route::Kind::quick, healthz},
    {"/readyz", "GET", false, Route::Kind::probe, readyz},
    {"/metrics", "GET", true, Route::Kind::probe, metrics},
    {"*", "GET", false, Route::Kind::quick, static_file}, // every other path
}};

bool method_matches(const Route& route, std::string_view method) {
    return route.method == method || (route.method == "GET" && method == "HEAD");
}

std::string methods_of(const Route& route) {
    return route.method == "GET" ? "GET, HEAD" : std::string(route.method) + ", OPTIONS";
}

const Route& route_of(std::string_view path) {
    for (const auto& route : table)
        if (route.path == path || route.path == "*") return route;
    return table.back();
}

Response refuse_token() {
    Response response = sentence(401, "The server needs its token; open the address that the server printed at its "
                                      "start, or send \"Authorization: Bearer TOKEN\".");
    response.headers.emplace_back("WWW-Authenticate", "Bearer");
    return response;
}

// Answers OPTIONS. Browsers send such a preflight before a script of another origin may POST JSON.
Response preflight(const Request& request, const Route& route) {
    Response response = sentence(204, "");
    response.body.clear();
    response.headers.emplace_back("Access-Control-Allow-Methods", std::string(route.method));
    response.headers.emplace_back("Access-Control-Allow-Headers", "content-type, authorization");
    response.headers.emplace_back("Allow", methods_of(route));
    if (!request.origin.empty()) response.headers.emplace_back("Access-Control-Max-Age", "600");
    return response;
}

// Media types are case-insensitive and may have parameters (RFC 9110, 8.3.1).
bool is_json(std::string_view content_type) {
    std::string type(content_type.substr(0, content_type.find(';')));
    while (!type.empty() && (type.back() == ' ' || type.back() == '\t')) type.pop_back();
    for (char& c : type)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return type == "application/json" || type == "application/json-rpc" || type == "application/jsonrequest";
}

std::optional<Response> refusal(const GatewayState& state, const Request& request, const Target& target,
                                const Route& route, Claim claim) {
    const bool changes_or_streams = route.kind == Route::Kind::websocket || route.method != "GET";
    if (changes_or_streams && !origin_allowed(state.access, request.origin, request.host))
        return sentence(403, "The origin " + request.origin + " may not use this server; allow it with --origin.");
    if (request.method == "OPTIONS" && route.method == "POST") return preflight(request, route);
    if (!method_matches(route, request.method)) {
        Response response = sentence(405, target.path + " does not accept the method " + request.method +
                                              "; use a method of the header Allow.");
        response.headers.emplace_back("Allow", methods_of(route));
        return response;
    }
    const bool offered_in_url = target.query.count("token") != 0;
    if ((route.needs_token || offered_in_url) && !is_let_in(claim)) return refuse_token();
    if (route.kind == Route::Kind::rpc && !is_json(request.content_type))
        return sentence(415, "The request must be JSON-RPC 2.0; send the header \"Content-Type: application/json\".");
    return std::nullopt;
}

// Redirects from PREFIX to PREFIX/, because relative links break without the slash.
Response to_prefix(const GatewayState& state, const Request& request) {
    Response response = sentence(308, "The client is at " + state.prefix + "/");
    const auto query = std::min(request.target.find('?'), request.target.size());
    response.headers.emplace_back("Location", state.prefix + "/" + request.target.substr(query));
    return response;
}

Resolved refused(Response response) { return {std::move(response), nullptr, {}, Claim::none}; }

} // namespace

std::span<const Route> routes() { return table; }

Resolved resolve(const GatewayState& state, const Request& request) {
    auto target = parse_target(request.target);
    if (!target)
        return refused(sentence(
            400, "The path or query of the request is malformed; check percent signs and control characters."));
    if (!host_allowed(state.access, request.host))
        return refused(sentence(403, "The host name " + request.host +
                                         " is not allowed on this server; allow it with --allowed-host."));
    const auto path = below_prefix(target->path, state.prefix);
    if (path.empty()) return refused(to_prefix(state, request));
    target->path = std::string(path);
    const Route& route = route_of(target->path);
    const Claim claim = claim_of(state.access, request, *target);
    if (auto response = refusal(state, request, *target, route, claim))
        return {std::move(response), nullptr, {}, claim};
    return {std::nullopt, &route, std::move(*target), claim};
}

Response respond(GatewayState& state, const Request& request, const Resolved& resolved) {
    Response response;
    if (resolved.refusal)
        response = *resolved.refusal;
    else
        try {
            response = resolved.route->handler(state, request, resolved.target);
        } catch (const std::exception& error) {
            logging::log_event(logging::LogLevel::error, "request failed",
                               {{"method", request.method},
                                {"path", resolved.target.path},
                                {"reason", error.what()},
                                {"request", request.id},
                                {"ms", request.milliseconds()},
                                {"remote", request.remote}});
            response = sentence(500, "The request failed; the log of the server names the reason.");
        }
    add_common_headers(state, request, response);
    return response;
}

} // namespace server::gateway
