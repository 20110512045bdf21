#include "import/source/array_selection.hpp"

#include "ciel/types.hpp"

#include <algorithm>

namespace server::importer {

std::string stored_name(const std::string& name) {
    std::string stored = name;
    std::replace_if(
        stored.begin(), stored.end(), [](unsigned char c) { return c == ':' || c < ' ' || c == 0x7F; }, '_');
    return stored;
}

bool ArraySelection::wants(const std::string& stored, bool cell_only) const {
    const auto selects = [&](const std::string& name) {
        return name == stored || stored_name(name) == stored || (cell_only && name == "cell:" + stored);
    };
    return selected_.empty() || std::any_of(selected_.begin(), selected_.end(), selects);
}

void ArraySelection::saw(const ArrayName& array) {
    const std::string name = stored_name(array.name);
    seen_.insert(name);
    if (array.of == FieldOf::cells) seen_.insert("cell:" + name); // `name`: point array interpolated from this array
}

bool ArraySelection::is_missing(const std::string& selected) const {
    return !seen_.contains(selected) && !seen_.contains(stored_name(selected));
}

bool ArraySelection::complete() const {
    return std::none_of(selected_.begin(), selected_.end(), [&](const auto& name) { return is_missing(name); });
}

void ArraySelection::check() const {
    std::string names;
    for (const std::string& name : seen_) names += (names.empty() ? "" : ", ") + name;
    for (const std::string& name : selected_)
        if (is_missing(name))
            throw ciel::Error("there is no array \"" + name + "\"; there are: " + (names.empty() ? "none" : names));
}

} // namespace server::importer
