#include "scene/read_json.hpp"

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace ciel::scene {

nlohmann::json read_json(std::string_view text) {
    using nlohmann::json;
    std::vector<std::set<std::string>> names; // member names read so far, per object that is not yet closed
    return json::parse(text.begin(), text.end(), [&](int, json::parse_event_t event, json& parsed) {
        if (event == json::parse_event_t::object_start)
            names.emplace_back();
        else if (event == json::parse_event_t::object_end)
            names.pop_back();
        else if (event == json::parse_event_t::key && !names.back().insert(parsed.get<std::string>()).second)
            throw TwiceNamed(parsed.dump() + " occurs twice in the same object; remove one of the two members");
        return true;
    });
}

} // namespace ciel::scene
