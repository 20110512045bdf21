#include "methods/request.hpp"

#include "methods/context.hpp"
#include "methods/error_answer.hpp"
#include "methods/method_params.hpp"
#include "protocol/method_table.hpp"
#include "session/metrics.hpp"

#include <algorithm>

namespace ciel::methods {
namespace {

using nlohmann::json;

json answer(const json& id, const char* member, json content) {
    return {{"jsonrpc", "2.0"}, {"id", id}, {member, std::move(content)}};
}

bool is_id(const json& id) { return id.is_string() || id.is_number() || id.is_null(); }

// The id of a request as far as it can be told, else null.
json id_of(const json& request) {
    if (!request.is_object()) return nullptr;
    const auto id = request.find("id");
    return id != request.end() && is_id(*id) ? *id : json();
}

bool is_request(const json& request) {
    if (!request.is_object() || request.value("jsonrpc", json()) != "2.0") return false;
    if (const auto method = request.find("method"); method == request.end() || !method->is_string()) return false;
    const auto params = request.find("params");
    return params == request.end() || params->is_structured();
}

const Method* find_method(const std::string& name) {
    const auto found = std::find_if(method_table.begin(), method_table.end(),
                                    [&](const Method& candidate) { return candidate.name == name; });
    return found == method_table.end() ? nullptr : found;
}

json call(Context& context, const json& request) {
    const auto& name = request["method"].get_ref<const std::string&>();
    const Method* method = find_method(name);
    context.server.counters().count_request(method == nullptr ? "unknown" : name);
    if (method == nullptr) throw MethodNotFound("there is no method " + name + "; rpc.discover lists them");
    return method->call(context, checked_params(name, request.value("params", json::object())));
}

json failed(Context& context, const json& request, json error) {
    context.server.counters().count_error(error["code"].get<int>());
    return answer(id_of(request), "error", std::move(error));
}

} // namespace

bool is_slow(const json& request) {
    if (!is_request(request)) return false;
    const Method* method = find_method(request["method"].get_ref<const std::string&>());
    return method != nullptr && method->slow;
}

std::optional<json> refuse(Context& context, const json& request) {
    json error = failed(context, request, error_of_current_exception());
    if (is_request(request) && !request.contains("id")) return {}; // a notification
    return error;
}

std::optional<json> handle(Context& context, const json& request) {
    if (!is_request(request))
        return failed(context, request, invalid_request("a request is an object with jsonrpc \"2.0\" and a method"));
    if (const auto id = request.find("id"); id != request.end() && !is_id(*id))
        return failed(context, request, invalid_request("an id is a text, a number or null"));
    try {
        json result = call(context, request);
        if (!request.contains("id")) return {};
        return answer(request["id"], "result", std::move(result));
    } catch (...) {
        return refuse(context, request);
    }
}

} // namespace ciel::methods
