// Converts exceptions to error objects of JSON-RPC 2.0 (section 5.1) with the codes of the contract.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace server::methods {

class InvalidRequest : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};
class MethodNotFound : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

[[nodiscard]] nlohmann::json parse_error(const std::string& reason);
[[nodiscard]] nlohmann::json invalid_request(const std::string& reason);
[[nodiscard]] nlohmann::json limit_error(const std::string& reason);
[[nodiscard]] nlohmann::json too_long_error(const std::string& reason);
// Returns the error object of the current exception, whatever its type. Call it inside a catch block.
[[nodiscard]] nlohmann::json error_of_current_exception();

} // namespace server::methods
