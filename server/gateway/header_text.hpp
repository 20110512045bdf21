// Common syntax of header fields (RFC 9110, 5.6): lists, white space, case-insensitive names.
#pragma once

#include <algorithm>
#include <string_view>

namespace server::gateway {

[[nodiscard]] inline char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

[[nodiscard]] inline bool same_ignoring_case(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

// Calls visit(item) for each item without white space around it, until visit returns true. Returns false if no visit
// did.
template <typename Visit>
bool any_item(std::string_view text, char separator, const Visit& visit) {
    while (!text.empty()) {
        const auto item = text.substr(0, text.find(separator));
        if (visit(trimmed(item))) return true;
        text.remove_prefix(std::min(item.size() + 1, text.size()));
    }
    return false;
}

} // namespace server::gateway
