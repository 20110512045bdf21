// JSON Schema, the part of it that openrpc.json uses, checked as data. Errors name the place as a JSON pointer.
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

// The first violation, or nothing. "$ref" is looked up in contract(). Keywords that are not in schema_keywords() are
// annotations and decide nothing. Thread-safe. Recursion follows the schema, so the depth of the value costs nothing.
[[nodiscard]] std::optional<Violation> check_schema(const nlohmann::json& schema, const nlohmann::json& value,
                                                    const std::string& path = "");

// Every keyword that is understood: a test holds the contract against it.
[[nodiscard]] std::vector<std::string> schema_keywords();

// `token` as one more step of a JSON pointer, with ~ and / escaped.
[[nodiscard]] std::string pointer_step(const std::string& path, const std::string& token);

} // namespace ciel::scene
