// Checks values against JSON Schema, limited to the keywords that openrpc.json uses.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ciel::scene {

// Returns the OpenRPC document (protocol/openrpc.json). It is parsed once.
[[nodiscard]] const nlohmann::json& contract();

struct Violation {
    std::string path;   // JSON pointer (RFC 6901) into the value
    std::string reason; // end of a sentence that begins with the path: "must be a number"
};

// Checks a value. Returns the first violation, or nothing. "$ref" is looked up in contract(). Keywords that are not in
// schema_keywords() are ignored. Thread-safe. The depth of the recursion depends on the schema, not on the value.
[[nodiscard]] std::optional<Violation> check_schema(const nlohmann::json& schema, const nlohmann::json& value,
                                                    const std::string& path = "");

// Returns the schema in contract() to which "$ref" points, or the schema itself if it has no "$ref".
[[nodiscard]] const nlohmann::json& resolved(const nlohmann::json& schema);

// Returns all supported keywords. A test compares them with the contract's keywords.
[[nodiscard]] std::vector<std::string> schema_keywords();

// Appends `token` to a JSON pointer, with ~ and / escaped.
[[nodiscard]] std::string pointer_step(const std::string& path, const std::string& token);

} // namespace ciel::scene
