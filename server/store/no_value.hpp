// no_value: the NaN that marks a missing value. A value is missing if a part of the input does not have the array or
// could not be read. Every other NaN and every infinity is treated as a wrong result of the solver.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace server::store {

// A quiet NaN. If it is converted to double, the double has the bits no_value_bits. If this double is converted to
// float, the result is no_value again.
inline constexpr float no_value = std::bit_cast<float>(std::uint32_t{0x7fc0ce1e});
inline constexpr std::uint64_t no_value_bits = 0x7ff819c3c0000000;

[[nodiscard]] inline bool is_no_value(double value) { return std::bit_cast<std::uint64_t>(value) == no_value_bits; }
// Returns true for a NaN or infinite result of the solver, but not for a missing value.
[[nodiscard]] inline bool went_wrong(double value) { return !std::isfinite(value) && !is_no_value(value); }

} // namespace server::store
