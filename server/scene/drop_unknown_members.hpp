// Removes members that a schema does not know. A client of a later minor version of the contract may send such members.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace ciel::scene {

// Works at all depths. Returns the JSON pointers (RFC 6901) of the removed members. Keeps a value outside its
// enumeration and an object of an unknown "type", because check_schema() refuses them. Thread-safe.
[[nodiscard]] std::vector<std::string> drop_unknown_members(const nlohmann::json& schema, nlohmann::json& value);

} // namespace ciel::scene
