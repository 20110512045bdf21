// XXH3-64 checksums of bytes. In JSON documents, a checksum is written as "xxh3:" and 16 hexadecimal digits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace server::store {

[[nodiscard]] std::uint64_t checksum_number(std::span<const std::byte> bytes);
// A stretch is a run of bytes of a chunk file that are read and checked together. stretch_bytes: its size; the last
// stretch of a file may be shorter. stretch_checksums returns the checksum of each stretch.
inline constexpr std::size_t stretch_bytes = 1 << 16;
[[nodiscard]] std::vector<std::uint64_t> stretch_checksums(std::span<const std::byte> bytes);
[[nodiscard]] std::string checksum(std::span<const std::byte> bytes);
[[nodiscard]] std::string checksum_text(std::uint64_t number);
[[nodiscard]] std::uint64_t checksum_number(const std::string& text); // parses a text that `checksum` returned
[[nodiscard]] bool is_checksum(const std::string& text);

} // namespace server::store
