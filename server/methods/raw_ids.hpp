// Ids of JSON-RPC requests with the characters that they came with: a parser makes a double of 1.50 or 2^64.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::methods {

// One entry for each request of the text, in order: its id where that is a number, as it stands in the text, else
// empty. REQUIRES: the text is JSON that nlohmann::json::parse accepts. Thread-safe.
[[nodiscard]] std::vector<std::string> raw_ids(std::string_view text);

struct IdsInRange {
    std::string text;                         // 0.5 stands in the place of each id that no double holds
    std::map<std::size_t, std::string> large; // these, by the number of their request
};
// For a text that the parser refuses since a number of it is beyond a double. Nothing where one is that is no id, or
// more than `most` are. Thread-safe.
[[nodiscard]] std::optional<IdsInRange> ids_in_range(std::string_view text, std::size_t most);

} // namespace ciel::methods
