// JSON Merge Patch, RFC 7396.
#include "scene/scene.hpp"

#include <nlohmann/json.hpp>

namespace server::scene {

using nlohmann::json;

json merge_patch(json document, const json& patch) {
    document.merge_patch(patch);
    return document;
}

json diff(const json& from, const json& to) {
    if (!from.is_object() || !to.is_object()) return to;
    json patch = json::object();
    for (const auto& [name, value] : from.items())
        if (!to.contains(name)) patch[name] = nullptr;
    for (const auto& [name, value] : to.items()) {
        const auto old = from.find(name);
        if (old == from.end())
            patch[name] = value;
        else if (*old != value)
            patch[name] = diff(*old, value);
    }
    return patch;
}

} // namespace server::scene
