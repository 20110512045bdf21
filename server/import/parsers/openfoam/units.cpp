#include "import/parsers/openfoam/units.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace server::importer {

namespace {

using Exponents = std::array<int, 7>; // kg m s K mol A cd
constexpr std::array<const char*, 7> base_units{"kg", "m", "s", "K", "mol", "A", "cd"};

std::optional<Exponents> read_exponents(const std::string& text) {
    Exponents exponents{};
    const char* at = text.c_str();
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        char* end = nullptr;
        const double value = std::strtod(at, &end);
        if (end == at) return i >= 5 ? std::optional(exponents) : std::nullopt; // older files list only five exponents
        if (!(std::abs(value) <= 99) || value != std::round(value)) return std::nullopt;
        exponents[i] = static_cast<int>(value);
        at = end;
    }
    return exponents;
}

std::string dimensions_entry(std::string_view head) {
    constexpr std::string_view keyword = "dimensions";
    for (std::size_t at = head.find(keyword); at != std::string_view::npos; at = head.find(keyword, at + 1)) {
        if (at > 0 && std::isspace(static_cast<unsigned char>(head[at - 1])) == 0) continue;
        const std::size_t open = head.find_first_not_of(" \t\r\n", at + keyword.size());
        if (open == std::string_view::npos || head[open] != '[') continue;
        const std::size_t close = head.find(']', open);
        return close == std::string_view::npos ? "" : std::string(head.substr(open + 1, close - open - 1));
    }
    return "";
}

std::string powers(const Exponents& exponents, int sign) {
    std::string text;
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        const int power = sign * exponents[i];
        if (power <= 0) continue;
        if (!text.empty()) text += ' ';
        text += base_units[i];
        if (power > 1) text += '^' + std::to_string(power);
    }
    return text;
}

} // namespace

std::string openfoam_units(std::string_view head) {
    const std::string inside = dimensions_entry(head);
    const auto exponents = read_exponents(inside);
    if (!exponents) return "";
    if (*exponents == Exponents{1, -1, -2}) return "Pa";
    std::string above = powers(*exponents, 1);
    const std::string below = powers(*exponents, -1);
    if (below.empty()) return above;
    return (above.empty() ? "1" : above) + '/' + (below.find(' ') == std::string::npos ? below : '(' + below + ')');
}

} // namespace server::importer
