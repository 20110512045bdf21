// Stable radix sort of items by a key of 32 bits, in linear time.
#pragma once

#include "render/context/pacing.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace server::render {

// Converts a float to an unsigned integer. The integers have the same order as the floats.
[[nodiscard]] inline std::uint32_t sortable(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}

// `other` is scratch memory. After cancelling (pacing.hpp), the contents of both vectors are unspecified.
template <typename Item>
void sort_by_key(const Gl& gl, std::vector<Item>& items, std::vector<Item>& other) {
    constexpr unsigned bits = 11;
    constexpr std::uint32_t mask = (1U << bits) - 1;
    other.resize(items.size());
    for (unsigned shift = 0; shift < 32; shift += bits) {
        std::array<std::size_t, mask + 2> begin{};
        in_pieces(gl, items.size(), [&](std::size_t i, std::size_t end) {
            for (; i < end; ++i) ++begin[((items[i].key >> shift) & mask) + 1];
        });
        for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
        in_pieces(gl, items.size(), [&](std::size_t i, std::size_t end) {
            for (; i < end; ++i) other[begin[(items[i].key >> shift) & mask]++] = items[i];
        });
        items.swap(other);
    }
}

} // namespace server::render
