// Checks values against JSON Schema, limited to the keywords that openrpc.json uses.
#pragma once

#include "scene/contract.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace server::scene {

// Checks a value. Returns the first violation, or nothing. "$ref" is looked up in contract(). Keywords that are not in
// schema_keywords() are ignored. Thread-safe. The depth of the recursion depends on the schema, not on the value.
[[nodiscard]] std::optional<Violation> check_schema(const nlohmann::json& schema, const nlohmann::json& value,
                                                    const std::string& path = "");

// Returns all supported keywords. A test compares them with the contract's keywords.
[[nodiscard]] std::vector<std::string> schema_keywords();

} // namespace server::scene
