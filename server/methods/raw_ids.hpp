// Ids of JSON-RPC requests as literal text: a parser would turn 1.50 or 2^64 into a double.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::methods {

// Returns one entry per request of the text, in order: the literal text of its id if that is a number, else empty.
// REQUIRES: the text is JSON that nlohmann::json::parse accepts. Thread-safe.
[[nodiscard]] std::vector<std::string> raw_ids(std::string_view text);

struct IdsInRange {
    std::string text;                         // has 0.5 in place of each id beyond the range of a double
    std::map<std::size_t, std::string> large; // the replaced ids, by index of the request
};
// Replaces ids beyond the range of a double, in a text that the parser refuses because of them. Returns nothing if such
// a number is not an id, or if there are more than `most`. Thread-safe.
[[nodiscard]] std::optional<IdsInRange> ids_in_range(std::string_view text, std::size_t most);

} // namespace ciel::methods
