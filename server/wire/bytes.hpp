// Reads and writes numbers as little-endian bytes.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <span>
#include <type_traits>
#include <vector>

namespace server::wire {

static_assert(std::endian::native == std::endian::little, "arrays of numbers are copied as they are in memory");

template <typename T>
requires std::is_arithmetic_v<T>
void put(std::uint8_t* out, T value) { std::memcpy(out, &value, sizeof value); }

template <typename T>
requires std::is_arithmetic_v<T>
[[nodiscard]] T get(const std::uint8_t* in) {
    T value;
    std::memcpy(&value, in, sizeof value);
    return value;
}

template <typename T>
requires std::is_trivially_copyable_v<T>
void append(std::vector<std::uint8_t>& out, std::span<const T> values) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
    out.insert(out.end(), bytes, bytes + values.size_bytes());
}

template <typename T>
requires std::is_trivially_copyable_v<T>
void write_raw(std::ostream& out, const T& value) { out.write(reinterpret_cast<const char*>(&value), sizeof value); }

} // namespace server::wire
