// Checks the params of a request against the contract's schemas.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace server::methods {

// Params by position get their names. Throws InvalidParams. `ignored`: if not null, unknown members are removed, and
// their JSON pointers are stored there. REQUIRES: the contract has the method, and `params` is an object or an array.
[[nodiscard]] nlohmann::json checked_params(const std::string& method, nlohmann::json params,
                                            std::vector<std::string>* ignored = nullptr);

} // namespace server::methods
