#include "scene/contract.hpp"

#include "protocol/document.hpp"

#include <nlohmann/json.hpp>

namespace server::scene {

using nlohmann::json;

const json& contract() {
    static const json document = [] {
        std::string text;
        for (const std::string_view part : protocol::document_parts) text += part;
        return json::parse(text);
    }();
    return document;
}

const json& resolved(const json& schema) {
    const auto reference = schema.find("$ref");
    if (reference == schema.end()) return schema;
    return contract().at(json::json_pointer(reference->get_ref<const std::string&>().substr(1)));
}

std::string pointer_step(const std::string& path, const std::string& token) {
    std::string step = path + "/";
    for (const char c : token) c == '~' ? step += "~0" : c == '/' ? step += "~1" : step += c;
    return step;
}

} // namespace server::scene
