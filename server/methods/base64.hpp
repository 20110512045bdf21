// Base64 (RFC 4648, section 4), for bytes inside JSON.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace ciel::methods {

[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

} // namespace ciel::methods
