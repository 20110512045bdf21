#include "gateway/handlers.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace server::gateway {
namespace {

constexpr const char* no_client_page = "<!doctype html><meta charset=\"utf-8\"><title>CIEL</title><h1>CIEL</h1><p>The "
                                       "server runs, but the web client was not "
                                       "found. Build it (npm run build in webclient/), or name its folder with "
                                       "--webclient. Scripts can use POST rpc.</p>\n";

std::string counter(const char* name, const char* help, const char* type, std::uint64_t value) {
    std::string text = std::string("# HELP ") + name + " " + help + "\n# TYPE " + name + " " + type + "\n";
    return text + name + " " + std::to_string(value) + "\n";
}

std::string gateway_metrics(GatewayState& state) {
    const Counters& counters = state.counters;
    std::string text =
        counter("ciel_gateway_connections_open", "Open TCP connections.", "gauge", state.connections.count());
    text += counter("ciel_gateway_websockets_open", "Open WebSockets.", "gauge", counters.websockets_open);
    text += counter("ciel_gateway_connections_total", "Connections accepted.", "counter", counters.connections);
    text += counter("ciel_gateway_connections_refused_total", "Connections over the limit.", "counter",
                    counters.refused_connections);
    text += counter("ciel_gateway_connections_cut_total", "Idle or unfinished connections closed for new ones.",
                    "counter", state.connections.cut_count());
    text +=
        counter("ciel_gateway_texts_received_total", "WebSocket texts received.", "counter", counters.texts_received);
    text += counter("ciel_gateway_texts_sent_total", "WebSocket texts sent.", "counter", counters.texts_sent);
    text += counter("ciel_gateway_frames_sent_total", "Binary frame messages sent.", "counter", counters.frames_sent);
    text += counter("ciel_gateway_frames_dropped_total", "Frame messages replaced by newer ones before they were sent.",
                    "counter", counters.frames_dropped);
    text += counter("ciel_gateway_websocket_sent_bytes_total", "Bytes sent over WebSockets.", "counter",
                    counters.bytes_sent);
    text += "# HELP ciel_gateway_responses_total HTTP responses by class of status; 1xx: opened WebSockets.\n"
            "# TYPE ciel_gateway_responses_total counter\n";
    for (std::size_t i = 1; i < counters.responses.size(); ++i)
        text += "ciel_gateway_responses_total{status=\"" + std::to_string(i) + "xx\"} " +
                std::to_string(counters.responses[i]) + "\n";
    return text;
}

} // namespace

Response websocket_expected(GatewayState&, const Request&, const Target&) {
    Response response = sentence(426, "This address is a WebSocket; connect with the subprotocol ciel.v1.");
    response.headers.emplace_back("Upgrade", "websocket");
    return response;
}

Response healthz(GatewayState&, const Request&, const Target&) { return sentence(200, "ok"); }

Response readyz(GatewayState& state, const Request&, const Target&) {
    Readiness readiness = state.service.readiness();
    if (state.draining) {
        readiness.ready = false;
        readiness.problem = "the server is about to stop";
    }
    nlohmann::json answer{{"ready", readiness.ready}, {"problem", readiness.problem}};
    for (const auto& [name, value] : readiness.facts) answer[name] = value;
    return json(readiness.ready ? 200 : 503, answer.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

Response metrics(GatewayState& state, const Request&, const Target&) {
    Response response = sentence(200, "");
    response.content_type = "text/plain; version=0.0.4; charset=utf-8";
    response.body = state.service.metrics();
    if (!response.body.empty() && !response.body.ends_with('\n')) response.body += '\n';
    response.body += gateway_metrics(state);
    return response;
}

Response static_file(GatewayState& state, const Request& request, const Target& target) {
    const StaticFile* file = state.files.find(target.path);
    Response response;
    if (file != nullptr)
        response = file_response(*file, request.if_none_match, request.accept_encoding);
    else if (target.path == "/" && state.files.count() == 0) {
        response = sentence(200, no_client_page);
        response.content_type = "text/html; charset=utf-8";
    } else
        return sentence(404, "The server has no page " + target.path + "; check the address.");
    // The server's own user may enter with a wrong token, which must not get into the cookie.
    const auto offered = target.query.find("token");
    if (offered != target.query.end() && token_allowed(state.access, offered->second))
        response.headers.emplace_back("Set-Cookie", token_cookie(state.access, request.forwarded_proto == "https"));
    return response;
}

void add_common_headers(const GatewayState& state, const Request& request, Response& response) {
    auto& headers = response.headers;
    headers.emplace_back("Server", "CIEL/" + state.version);
    headers.emplace_back("X-Request-Id", request.id);
    headers.emplace_back("X-Content-Type-Options", "nosniff");
    headers.emplace_back("Referrer-Policy", "no-referrer"); // the URL may contain the token
    headers.emplace_back("Cross-Origin-Resource-Policy", "same-origin");
    std::string ancestors = "'self'";
    for (const auto& origin : state.access.origins) ancestors += " " + origin;
    headers.emplace_back("Content-Security-Policy",
                         "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; "
                         "img-src 'self' blob: data:; worker-src 'self' blob:; object-src 'none'; base-uri 'none'; "
                         "form-action 'self'; frame-ancestors " +
                             ancestors);
    const auto& origins = state.access.origins;
    if (std::find(origins.begin(), origins.end(), request.origin) != origins.end()) {
        headers.emplace_back("Access-Control-Allow-Origin", request.origin);
        headers.emplace_back("Vary", "Origin");
    }
}

} // namespace server::gateway
