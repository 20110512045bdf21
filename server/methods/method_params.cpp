#include "methods/method_params.hpp"

#include "methods/call_context.hpp"
#include "scene/schema.hpp"
#include "scene/unknown_members.hpp"

#include <map>

namespace server::methods {
namespace {

using nlohmann::json;

struct ParamsSchema { // NOLINT(bugprone-exception-escape): moving a json does not throw
    std::vector<std::string> order;
    json schema; // schema of the params as one object
};

std::map<std::string, ParamsSchema> make_schemas() {
    std::map<std::string, ParamsSchema> schemas;
    for (const json& method : scene::contract().at("methods")) {
        ParamsSchema& made = schemas[method.at("name")];
        made.schema = {{"type", "object"},
                       {"properties", json::object()},
                       {"required", json::array()},
                       {"additionalProperties", false}};
        for (const json& param : method.at("params")) {
            const std::string name = param.at("name");
            made.order.push_back(name);
            made.schema["properties"][name] = param.at("schema");
            if (param.value("required", false)) made.schema["required"].push_back(name);
        }
    }
    return schemas;
}

json by_name(const json& params, const std::vector<std::string>& order) {
    if (params.size() > order.size())
        throw InvalidParams("/" + std::to_string(order.size()), "the call has " + std::to_string(params.size()) +
                                                                    " params; the method takes at most " +
                                                                    std::to_string(order.size()));
    json named = json::object();
    for (std::size_t i = 0; i < params.size(); ++i) named[order[i]] = params[i];
    return named;
}

} // namespace

json checked_params(const std::string& method, json params, std::vector<std::string>* ignored) {
    static const std::map<std::string, ParamsSchema> schemas = make_schemas();
    const ParamsSchema& expected = schemas.at(method);
    if (params.is_array()) params = by_name(params, expected.order);
    if (ignored != nullptr) *ignored = scene::drop_unknown_members(expected.schema, params);
    if (const auto violation = scene::check_schema(expected.schema, params))
        throw InvalidParams(violation->path, violation->path + " " + violation->reason);
    return params;
}

} // namespace server::methods
