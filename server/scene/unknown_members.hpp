// Members that a schema does not know. A client of a later minor version of the contract may send them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace ciel::scene {

// Removes all unknown members from `value`, at all depths, and returns their JSON pointers (RFC 6901) into it. A value
// that is no member of its enumeration, or of an unknown "type", stays: check_schema refuses it. Thread-safe.
[[nodiscard]] std::vector<std::string> drop_unknown_members(const nlohmann::json& schema, nlohmann::json& value);

} // namespace ciel::scene
