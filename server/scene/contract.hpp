// The OpenRPC document (protocol/openrpc.json), and how a violation of its schemas is described.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace server::scene {

// Returns the OpenRPC document. It is parsed once.
[[nodiscard]] const nlohmann::json& contract();

// Returns the schema in contract() to which "$ref" points, or the schema itself if it has no "$ref".
[[nodiscard]] const nlohmann::json& resolved(const nlohmann::json& schema);

struct Violation {
    std::string path;   // JSON pointer (RFC 6901) into the value
    std::string reason; // end of a sentence that begins with the path: "must be a number"
};

// Appends `token` to a JSON pointer, with ~ and / escaped.
[[nodiscard]] std::string pointer_step(const std::string& path, const std::string& token);

} // namespace server::scene
