// Base64 (RFC 4648, section 4), for bytes inside JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::methods {

[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);
// Returns the bytes; nothing if `text` is not canonical, that is padded, without blanks, with unused bits zero.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> from_base64(std::string_view text);

} // namespace ciel::methods
