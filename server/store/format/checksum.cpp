#include "store/format/checksum.hpp"

#include <algorithm>
#include <string_view>
#include <xxhash.h>

namespace server::store {
namespace {
constexpr std::string_view prefix = "xxh3:";
constexpr std::string_view digits = "0123456789abcdef";
} // namespace

std::uint64_t checksum_number(std::span<const std::byte> bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

std::vector<std::uint64_t> stretch_checksums(std::span<const std::byte> bytes) {
    std::vector<std::uint64_t> sums;
    for (std::size_t begin = 0; begin < bytes.size(); begin += stretch_bytes)
        sums.push_back(checksum_number(bytes.subspan(begin, std::min(stretch_bytes, bytes.size() - begin))));
    return sums;
}

std::string checksum(std::span<const std::byte> bytes) { return checksum_text(checksum_number(bytes)); }

std::string checksum_text(std::uint64_t number) {
    std::string text(prefix);
    for (int shift = 60; shift >= 0; shift -= 4) text += digits[(number >> shift) & 15];
    return text;
}

std::uint64_t checksum_number(const std::string& text) {
    std::uint64_t hash = 0;
    for (const char digit : text.substr(prefix.size())) hash = hash << 4 | digits.find(digit);
    return hash;
}

bool is_checksum(const std::string& text) {
    return text.size() == prefix.size() + 16 && text.starts_with(prefix) &&
           std::all_of(text.begin() + prefix.size(), text.end(),
                       [](char c) { return digits.find(c) != std::string_view::npos; });
}

} // namespace server::store
