// The version of the contract that a request declares: its member "protocol", {"major": 1, "minor": 4}.
#pragma once

#include <nlohmann/json.hpp>

namespace ciel::methods {

// Returns whether the request was written for a higher minor version than the version of this server. If so, unknown
// members of the request are ignored. Returns false if the request has no "protocol". Throws InvalidRequest for another
// major version, and if "protocol" is malformed.
[[nodiscard]] bool is_of_later_minor(const nlohmann::json& request);

} // namespace ciel::methods
