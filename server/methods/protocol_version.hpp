// The version of the contract that a request declares: its member "protocol", {"major": 1, "minor": 4}.
#pragma once

#include <nlohmann/json.hpp>

namespace server::methods {

// Returns whether the request declares a higher minor version than this server. The request's unknown members are then
// ignored. Returns false without "protocol". Throws InvalidRequest for another major version or a malformed "protocol".
[[nodiscard]] bool is_of_later_minor(const nlohmann::json& request);

} // namespace server::methods
