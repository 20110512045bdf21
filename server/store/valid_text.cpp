#include "store/valid_text.hpp"

#include "store/format/json_reader.hpp"

namespace server::store {

ArrayInfo with_valid_text(const ArrayInfo& info) {
    ArrayInfo valid = info;
    for (std::string* text : {&valid.name, &valid.units, &valid.description, &valid.source.type, &valid.source.file})
        *text = valid_utf8(*text);
    for (std::string& name : valid.component_names) name = valid_utf8(name);
    return valid;
}

std::vector<NamedGroup> with_valid_text(std::span<const NamedGroup> groups) {
    std::vector<NamedGroup> valid(groups.begin(), groups.end());
    for (NamedGroup& group : valid) {
        group.name = valid_utf8(group.name);
        group.facts.type = valid_utf8(group.facts.type);
        std::map<std::string, std::string> conditions;
        for (const auto& [array, condition] : group.facts.conditions)
            conditions.emplace(valid_utf8(array), valid_utf8(condition));
        group.facts.conditions = std::move(conditions);
    }
    return valid;
}

} // namespace server::store
