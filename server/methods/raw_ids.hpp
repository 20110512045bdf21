// Ids of JSON-RPC requests with the characters that they came with: a parser makes a double of 1.50 or 2^64.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ciel::methods {

// One entry for each request of the text, in order: its id where that is a number, as it stands in the text, else
// empty. REQUIRES: the text is JSON that nlohmann::json::parse accepts. Thread-safe.
[[nodiscard]] std::vector<std::string> raw_ids(std::string_view text);

} // namespace ciel::methods
