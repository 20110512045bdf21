// Checks values against JSON Schema, limited to the keywords that openrpc.json uses.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ciel::scene {

// The OpenRPC document, parsed once.
[[nodiscard]] const nlohmann::json& contract();

struct Violation {
    std::string path;   // RFC 6901, into the value
    std::string reason; // the rest of a sentence: "must be a number"
};

// Returns the first violation, or nothing. "$ref" is looked up in contract(). Keywords that are not in
// schema_keywords() are ignored. Thread-safe. Recursion follows the schema, not the depth of the value.
[[nodiscard]] std::optional<Violation> check_schema(const nlohmann::json& schema, const nlohmann::json& value,
                                                    const std::string& path = "");

// Follows "$ref", which is looked up in contract().
[[nodiscard]] const nlohmann::json& resolved(const nlohmann::json& schema);

// All supported keywords; a test compares them with the contract's.
[[nodiscard]] std::vector<std::string> schema_keywords();

// Appends `token` to a JSON pointer, with ~ and / escaped.
[[nodiscard]] std::string pointer_step(const std::string& path, const std::string& token);

} // namespace ciel::scene
