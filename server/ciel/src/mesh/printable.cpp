#include "ciel/printable.hpp"

namespace ciel {

std::string printable(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string out;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code >= 0x20 && code != 0x7f)
            out += c;
        else
            out.append("\\u00").append(1, digits[code >> 4U]).append(1, digits[code & 15U]);
    }
    return out;
}

} // namespace ciel
