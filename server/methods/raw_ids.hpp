// Ids of JSON-RPC requests as literal text, because a parser would turn 1.50 or 2^64 into a double.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace server::methods {

// Returns one entry per request, empty if its id is not a number. REQUIRES: json::parse accepts the text. Thread-safe.
[[nodiscard]] std::vector<std::string> raw_ids(std::string_view text);

struct IdsInRange {
    std::string text;                         // has 0.5 in place of each id beyond the range of a double
    std::map<std::size_t, std::string> large; // the replaced ids, by index of the request
};
// Replaces the ids beyond the range of a double, because the parser refuses such numbers. Returns nothing if such a
// number is not an id, or if there are more than `most` such ids. Thread-safe.
[[nodiscard]] std::optional<IdsInRange> ids_in_range(std::string_view text, std::size_t most);

} // namespace server::methods
