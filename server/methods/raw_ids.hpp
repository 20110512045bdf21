// Ids of JSON-RPC requests as literal text, because a parser would turn 1.50 or 2^64 into a double.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::methods {

// Returns one entry per request of the text, in order. The entry is the literal text of the request's id if the id is a
// number, else empty. REQUIRES: the text is JSON that nlohmann::json::parse accepts. Thread-safe.
[[nodiscard]] std::vector<std::string> raw_ids(std::string_view text);

struct IdsInRange {
    std::string text;                         // has 0.5 in place of each id beyond the range of a double
    std::map<std::size_t, std::string> large; // the replaced ids, by index of the request
};
// Replaces the ids in `text` that are beyond the range of a double, because the parser refuses a text with such
// numbers. Returns nothing if such a number is not an id, or if there are more than `most` such ids. Thread-safe.
[[nodiscard]] std::optional<IdsInRange> ids_in_range(std::string_view text, std::size_t most);

} // namespace ciel::methods
