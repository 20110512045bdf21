// Params of a request, checked against the contract's schemas.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ciel::methods {

// By-position params become by-name ones, in the declared order. Throws InvalidParams. `ignored`: not null if unknown
// members are to be removed; receives their JSON pointers. REQUIRES: the contract has the method, and `params` is an
// object or an array.
[[nodiscard]] nlohmann::json checked_params(const std::string& method, nlohmann::json params,
                                            std::vector<std::string>* ignored = nullptr);

} // namespace ciel::methods
