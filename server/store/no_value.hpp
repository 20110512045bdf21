// no_value: the NaN that marks a missing value, such as in a block without the array or in a piece that could not be
// read. Every other NaN and the infinities are results of the solver, which count as wrong.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace ciel::store {

inline constexpr std::uint32_t no_value_bits = 0x7fc0ce1e; // a quiet NaN
inline constexpr float no_value = std::bit_cast<float>(no_value_bits);

[[nodiscard]] inline bool is_no_value(float value) { return std::bit_cast<std::uint32_t>(value) == no_value_bits; }
// Returns whether the value is a NaN or infinite result of the solver, and not a missing value.
[[nodiscard]] inline bool went_wrong(float value) { return !std::isfinite(value) && !is_no_value(value); }

} // namespace ciel::store
