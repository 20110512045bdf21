// Base64 (RFC 4648, section 4), for bytes inside JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace server::methods {

[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);
// Decodes canonical base64: padded, without white space, with unused bits zero. Returns nothing for other text.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> from_base64(std::string_view text);

} // namespace server::methods
