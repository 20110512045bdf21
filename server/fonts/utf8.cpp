// Decodes UTF-8 as in Unicode 15, section 3.9: each maximal subpart of an ill-formed sequence becomes one U+FFFD.
#include "fonts/font.hpp"

namespace server::fonts {
namespace {

constexpr char32_t replacement = 0xFFFD;

struct Lead {
    int following = 0;           // number of bytes that must follow the lead byte
    char32_t bits = replacement; // bits of the code point in the lead byte; U+FFFD if the byte cannot begin a character
    // Valid range of the next byte. It excludes overlong forms, surrogates and values above U+10FFFF.
    std::uint8_t low = 0x80, high = 0xBF;
};

Lead lead_of(std::uint8_t byte) {
    if (byte < 0x80) return {0, byte};
    if (byte >= 0xC2 && byte <= 0xDF) return {1, byte & 0x1FU};
    if (byte >= 0xE0 && byte <= 0xEF)
        return {2, byte & 0x0FU, static_cast<std::uint8_t>(byte == 0xE0 ? 0xA0 : 0x80),
                static_cast<std::uint8_t>(byte == 0xED ? 0x9F : 0xBF)};
    if (byte >= 0xF0 && byte <= 0xF4)
        return {3, byte & 0x07U, static_cast<std::uint8_t>(byte == 0xF0 ? 0x90 : 0x80),
                static_cast<std::uint8_t>(byte == 0xF4 ? 0x8F : 0xBF)};
    return {};
}

} // namespace

std::u32string decode_utf8(std::string_view text) {
    std::u32string out;
    for (std::size_t i = 0; i < text.size();) {
        Lead lead = lead_of(static_cast<std::uint8_t>(text[i++]));
        for (; lead.following > 0; --lead.following, ++i) {
            const auto byte = static_cast<std::uint8_t>(i < text.size() ? text[i] : 0);
            if (byte < lead.low || byte > lead.high) break;
            lead.bits = (lead.bits << 6U) | (byte & 0x3FU);
            lead.low = 0x80;
            lead.high = 0xBF;
        }
        out += lead.following > 0 ? replacement : lead.bits;
    }
    return out;
}

} // namespace server::fonts
