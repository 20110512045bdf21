// XXH3-64 of a file's bytes, as the store writes it: "xxh3:" and 16 hexadecimal digits.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace ciel::store {

[[nodiscard]] std::string checksum(std::span<const std::byte> bytes);
[[nodiscard]] bool is_checksum(const std::string& text);

} // namespace ciel::store
