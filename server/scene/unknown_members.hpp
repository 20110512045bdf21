// Refuses or removes members that a schema does not know. A client of a later minor version of the contract may send
// such members; methods/method_params.cpp chooses between refusing and removing.
#pragma once

#include "scene/contract.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace server::scene {

// Returns whether `schema` has a property with this name. Does not resolve "$ref".
[[nodiscard]] bool is_known_member(const nlohmann::json& schema, const std::string& name);

// Returns the violation by the first unknown member, or nothing. The "additionalProperties" of the schema must be
// false. Checks the members of `value` only, not nested members. Thread-safe.
[[nodiscard]] std::optional<Violation> refuse_unknown_members(const nlohmann::json& schema, const nlohmann::json& value,
                                                              const std::string& path);

// Removes unknown members at all depths. Returns the JSON pointers (RFC 6901) of the removed members. Keeps a value
// outside its enumeration and an object of an unknown "type", because check_schema() refuses them. Thread-safe.
[[nodiscard]] std::vector<std::string> drop_unknown_members(const nlohmann::json& schema, nlohmann::json& value);

} // namespace server::scene
