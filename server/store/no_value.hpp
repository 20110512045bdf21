// A NaN that says "there is no value here": a block without the array, a piece that could not be read. Every other NaN
// and the infinities are values that went wrong, and what shows them says so. Its bits survive being stored as float32.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace ciel::store {

inline constexpr std::uint32_t no_value_bits = 0x7fc0ce1e; // a quiet NaN
inline constexpr float no_value = std::bit_cast<float>(no_value_bits);

[[nodiscard]] inline bool is_no_value(float value) { return std::bit_cast<std::uint32_t>(value) == no_value_bits; }
// A number that a solver should not have come to.
[[nodiscard]] inline bool went_wrong(float value) { return !std::isfinite(value) && !is_no_value(value); }

} // namespace ciel::store
