#include "methods/dispatcher.hpp"

#include "methods/context.hpp"
#include "methods/error_answer.hpp"
#include "methods/method_params.hpp"
#include "protocol/method_table.hpp"

#include <algorithm>
#include <optional>

namespace ciel::methods {
namespace {

using nlohmann::json;

// Deeper than `limit`? Looked at before parsing, so that no parser or destructor recurses that deep.
bool is_deeper_than(std::string_view text, std::size_t limit) {
    std::size_t depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                in_string = false;
        } else if (c == '"') {
            in_string = true;
        } else if (c == '[' || c == '{') {
            if (++depth > limit) return true;
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return false;
}

json answer(const json& id, const char* member, json content) {
    return {{"jsonrpc", "2.0"}, {"id", id}, {member, std::move(content)}};
}

// Other numbers would come back rounded, and the client would not know its request again.
bool is_id(const json& id) { return id.is_string() || id.is_number_integer() || id.is_null(); }

// The id of a request as far as it can be told, else null.
json id_of(const json& request) {
    if (!request.is_object()) return nullptr;
    const auto id = request.find("id");
    return id != request.end() && is_id(*id) ? *id : json();
}

bool is_request(const json& request) {
    if (!request.is_object() || request.value("jsonrpc", json()) != "2.0") return false;
    if (const auto method = request.find("method"); method == request.end() || !method->is_string()) return false;
    if (const auto params = request.find("params"); params != request.end() && !params->is_structured()) return false;
    return true;
}

json call(Context& context, const json& request) {
    const auto& name = request["method"].get_ref<const std::string&>();
    const auto method = std::find_if(method_table.begin(), method_table.end(),
                                     [&](const Method& candidate) { return candidate.name == name; });
    context.server.counters().count_request(method == method_table.end() ? "unknown" : name);
    if (method == method_table.end()) throw MethodNotFound("there is no method " + name + "; rpc.discover lists them");
    return method->call(context, checked_params(name, request.value("params", json::object())));
}

// Nothing when there is nothing to be answered.
std::optional<json> handle(Context& context, const json& request) {
    auto& metrics = context.server.counters();
    const auto failed = [&](json error) {
        metrics.count_error(error["code"].get<int>());
        return answer(id_of(request), "error", std::move(error));
    };
    if (!is_request(request))
        return failed(invalid_request("a request is an object with jsonrpc \"2.0\" and a method"));
    if (const auto id = request.find("id"); id != request.end() && !is_id(*id))
        return failed(invalid_request("an id is a text, null, or a whole number of 64 bits; write others as text"));
    const bool is_notification = !request.contains("id");
    try {
        json result = call(context, request);
        if (is_notification) return {};
        return answer(request["id"], "result", std::move(result));
    } catch (...) {
        json error = failed(error_of_current_exception());
        if (is_notification) return {};
        return error;
    }
}

std::optional<json> handle_batch(Context& context, const json& batch) {
    json answers = json::array();
    for (const json& request : batch)
        if (auto one = handle(context, request)) answers.push_back(std::move(*one));
    if (answers.empty()) return {};
    return answers;
}

std::optional<json> handle_text(Context& context, std::string_view text) {
    const session::Limits& limits = context.server.limits();
    const auto refused = [&](json error) {
        context.server.counters().count_error(error["code"].get<int>());
        return answer(nullptr, "error", std::move(error));
    };
    if (text.size() > limits.message_bytes)
        return refused(limit_error("a message may have " + std::to_string(limits.message_bytes) + " bytes"));
    if (is_deeper_than(text, limits.json_depth))
        return refused(limit_error("JSON may be " + std::to_string(limits.json_depth) + " levels deep"));
    json request;
    try {
        request = json::parse(text.begin(), text.end());
    } catch (const json::out_of_range&) {
        return refused(parse_error("a number in the message is too large; the largest is about 1.8e308"));
    } catch (const json::exception&) {
        return refused(parse_error("the message is not valid JSON"));
    }
    if (!request.is_array()) return handle(context, request);
    if (request.empty()) return refused(invalid_request("a batch must not be empty"));
    if (request.size() > limits.batch_requests)
        return refused(limit_error("a batch may have " + std::to_string(limits.batch_requests) + " requests"));
    return handle_batch(context, request);
}

} // namespace

std::string dispatch(session::Server& server, session::Connection& connection, std::string_view text) {
    Context context{server, connection};
    const auto reply = handle_text(context, text);
    // A name from a file system may not be UTF-8.
    return reply ? reply->dump(-1, ' ', false, json::error_handler_t::replace) : std::string();
}

} // namespace ciel::methods
