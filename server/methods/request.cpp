#include "methods/request.hpp"

#include "engine/metrics.hpp"
#include "logging/log.hpp"
#include "methods/call_context.hpp"
#include "methods/error_answer.hpp"
#include "methods/method_params.hpp"
#include "methods/progress.hpp"
#include "methods/protocol_version.hpp"
#include "protocol/method_table.hpp"
#include "store/loaded.hpp"

#include <algorithm>

namespace server::methods {
namespace {

using nlohmann::json;

constexpr int internal_error = -32603;
// Calls that take longer are logged as slow. slow_call_ms is for methods with x-slow in the contract.
constexpr double slow_quick_call_ms = 1000, slow_call_ms = 10'000;

json answer(const json& id, const char* member, json content) {
    return {{"jsonrpc", "2.0"}, {"id", id}, {member, std::move(content)}};
}

bool is_id(const json& id) { return id.is_string() || id.is_number() || id.is_null(); }

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

// All methods with x-slow have the parameter `progress`.
void tell_of_reading(const CallContext& context, const json& params) {
    const auto member = [&](const char* name) -> std::optional<std::string> {
        const auto found = params.find(name);
        return found == params.end() ? std::nullopt : std::optional(found->get<std::string>());
    };
    Progress(context, member("progress"), member("session")).begin("reading");
}

json call_slow(CallContext& context, const Method& method, const json& params) {
    try {
        return method.call(context, params);
    } catch (const store::NotYetRead& late) {
        const double longest_ms = 1000.0 * static_cast<double>(context.server.limits().late_step_seconds);
        if (late.has_failed || context.milliseconds() > longest_ms) throw;
        tell_of_reading(context, params);
        throw AwaitsStep();
    }
}

// `ignored` receives the JSON pointers of unknown members if the request declares a later minor version.
json call(CallContext& context, const json& request, bool is_again, std::vector<std::string>& ignored) {
    const auto& name = request["method"].get_ref<const std::string&>();
    const Method* method = find_method(name);
    if (!is_again) context.server.counters().count_request(method == nullptr ? "unknown" : name);
    if (method == nullptr) throw MethodNotFound("there is no method " + name + "; rpc.discover lists the methods");
    const auto count = [&] { context.server.counters().count_call(name, context.milliseconds() / 1000); };
    try {
        std::vector<std::string>* const dropped = is_of_later_minor(request) ? &ignored : nullptr;
        const json params = checked_params(name, request.value("params", json::object()), dropped);
        json result = method->slow ? call_slow(context, *method, params) : method->call(context, params);
        count();
        return result;
    } catch (const AwaitsStep&) { // the call is handled again later and counted then
        throw;
    } catch (...) {
        count();
        throw;
    }
}

// Failures of the server are warnings or errors; mistakes of a client are information.
logging::LogLevel level_of(int code) {
    if (code == internal_error) return logging::LogLevel::error;
    return code == protocol::Failed || code == protocol::Limit ? logging::LogLevel::warning : logging::LogLevel::info;
}

// Returns "unknown" for a name outside the contract, because such a name is arbitrary text of the client.
std::string method_of(const json& request) {
    if (!is_request(request)) return {};
    const auto& name = request["method"].get_ref<const std::string&>();
    return find_method(name) == nullptr ? "unknown" : name;
}

std::string session_of(const json& request) {
    const auto params = request.is_object() ? request.find("params") : request.end();
    if (!request.is_object() || params == request.end() || !params->is_object()) return {};
    const auto id = params->find("session");
    return id != params->end() && id->is_string() ? logging::short_id(id->get_ref<const std::string&>()) : "";
}

json failed(CallContext& context, const json& request, json error) {
    const int code = error["code"].get<int>();
    context.server.counters().count_error(code);
    error["data"]["request"] = context.request_id;
    logging::log_event(level_of(code), "call failed",
                       {{"method", method_of(request)},
                        {"code", code},
                        {"reason", error["data"]["reason"].get_ref<const std::string&>()},
                        {"session", session_of(request)},
                        {"request", context.request_id},
                        {"user", context.connection.user},
                        {"remote", context.connection.remote},
                        {"ms", context.milliseconds()}});
    return answer(id_of(request), "error", std::move(error));
}

void tell_if_slow(const CallContext& context, const json& request, double waited) {
    const double took = context.milliseconds();
    if (took < (is_slow(request) ? slow_call_ms : slow_quick_call_ms)) return;
    logging::log_event(logging::LogLevel::warning, "slow call",
                       {{"method", method_of(request)},
                        {"session", session_of(request)},
                        {"request", context.request_id},
                        {"user", context.connection.user},
                        {"remote", context.connection.remote},
                        {"waited_ms", 1000 * waited},
                        {"ms", took}});
}

} // namespace

bool is_slow(const json& request) {
    if (!is_request(request)) return false;
    const Method* method = find_method(request["method"].get_ref<const std::string&>());
    return method != nullptr && method->slow;
}

json refuse_text(CallContext& context, json error) {
    context.begin();
    return failed(context, nullptr, std::move(error));
}

std::optional<json> refuse(CallContext& context, const json& request) {
    json error = failed(context, request, error_of_current_exception());
    if (is_request(request) && !request.contains("id")) return {}; // a notification
    return error;
}

std::optional<json> handle(CallContext& context, const json& request, Turn turn) {
    if (!turn.is_again) context.begin();
    if (!is_request(request))
        return failed(context, request,
                      invalid_request("a request must be an object with jsonrpc \"2.0\" and a method"));
    if (const auto id = request.find("id"); id != request.end() && !is_id(*id))
        return failed(context, request, invalid_request("the id of a request must be a string, a number or null"));
    try {
        std::vector<std::string> ignored;
        json result = call(context, request, turn.is_again, ignored);
        tell_if_slow(context, request, turn.waited);
        if (!request.contains("id")) return {};
        json answered = answer(request["id"], "result", std::move(result));
        if (!ignored.empty()) answered["ignored"] = std::move(ignored);
        return answered;
    } catch (const AwaitsStep&) {
        throw;
    } catch (...) {
        return refuse(context, request);
    }
}

} // namespace server::methods
