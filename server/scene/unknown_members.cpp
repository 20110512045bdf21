#include "scene/unknown_members.hpp"

#include <nlohmann/json.hpp>

namespace server::scene {
namespace {

using nlohmann::json;

std::string known_members(const json& schema) {
    std::string names;
    if (const auto known = schema.find("properties"); known != schema.end())
        for (const auto& [name, member] : known->items())
            names += (names.empty() ? "; the known members are " : ", ") + name;
    return names;
}

struct Dropping {
    std::vector<std::string> paths;

    void visit(const json& schema, json& value, const std::string& path) {
        if (const auto document = schema.find("x-patch-of"); document != schema.end())
            return visit({{"$ref", *document}}, value, path);
        const json& known = resolved(schema);
        for (const char* options : {"anyOf", "oneOf"})
            if (known.contains(options)) visit(form_of(known[options], value), value, path);
        if (value.is_object())
            visit_members(known, value, path);
        else if (value.is_array() && known.contains("items"))
            for (std::size_t i = 0; i < value.size(); ++i)
                visit(known["items"], value[i], path + "/" + std::to_string(i));
    }

private:
    // A patch may omit the "type". Then the schema has the members of all options.
    static json form_of(const json& options, const json& value) {
        json all{{"properties", json::object()}};
        for (const json& option : options) {
            const json& form = resolved(option);
            if (!form.contains("properties")) continue;
            const json type = form["properties"].value("type", json::object()).value("const", json());
            if (value.is_object() && value.contains("type") && type == value["type"]) return form;
            all["properties"].update(form["properties"]);
            all["additionalProperties"] = false;
        }
        return all;
    }

    void visit_members(const json& known, json& object, const std::string& path) {
        const json properties = known.value("properties", json::object());
        const json others = known.value("additionalProperties", json(true));
        for (auto member = object.begin(); member != object.end();) {
            const std::string place = pointer_step(path, member.key());
            if (const auto property = properties.find(member.key()); property != properties.end()) {
                visit(*property, *member, place);
            } else if (others == false) {
                paths.push_back(place);
                member = object.erase(member);
                continue;
            } else if (others.is_object()) {
                visit(others, *member, place);
            }
            ++member;
        }
    }
};

} // namespace

bool is_known_member(const json& schema, const std::string& name) {
    const auto known = schema.find("properties");
    return known != schema.end() && known->contains(name);
}

std::optional<Violation> refuse_unknown_members(const json& schema, const json& value, const std::string& path) {
    if (!value.is_object()) return {};
    for (const auto& [name, member] : value.items())
        if (!is_known_member(schema, name))
            return Violation{pointer_step(path, name), "is not a known member" + known_members(schema)};
    return {};
}

std::vector<std::string> drop_unknown_members(const json& schema, json& value) {
    Dropping dropping;
    dropping.visit(schema, value, "");
    return std::move(dropping.paths);
}

} // namespace server::scene
