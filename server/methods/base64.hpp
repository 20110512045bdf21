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
// Nothing unless `text` is what base64() makes of some bytes: padded, without blanks, its unused bits zero.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> from_base64(std::string_view text);

} // namespace ciel::methods
