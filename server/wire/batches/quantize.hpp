// Positions, normals and values as the small integers that polygon batches carry (protocol/frame.md).
#pragma once

#include "ciel/types.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ciel::wire {

// Returns the largest power of two that is at most `wanted`, but at least the float resolution at `largest`. Multiples
// of it up to `largest` are floats, so quantized positions are decoded exactly.
[[nodiscard]] double grid_step(double wanted, double largest);

// The nearest multiple of the step; the error is at most half a step. Equal for equal positions in all batches.
[[nodiscard]] inline std::int32_t on_grid(float position, double inverse_step) {
    constexpr double most = 1 << 30;
    const double place = std::min(std::max(-most, position * inverse_step), most); // also for NaN
    return static_cast<std::int32_t>(place < 0 ? place - 0.5 : place + 0.5);
}

// Maps a unit vector to the octahedron |x| + |y| + |z| = 1, folded to a square of 255 x 255 places. The mean error is
// 0.34 degrees, the largest 0.95. (Cigolle et al., "A Survey of Efficient Representations for Independent Unit
// Vectors", 2014)
[[nodiscard]] std::array<std::int8_t, 2> octahedral(const Vec3f& normal);
[[nodiscard]] Vec3f from_octahedral(const std::array<std::int8_t, 2>& place);

inline constexpr std::uint32_t no_value = std::numeric_limits<std::uint32_t>::max(); // NaN

// value = origin + step * (low + place); `low` is the minimum of the batch.
struct QuantizedValues {
    std::int64_t low = 0;
    std::vector<std::uint32_t> places;
};
// The error is at most half a step. Values are clamped to 2^30 steps from `origin`. NaN becomes no_value.
[[nodiscard]] QuantizedValues quantized(std::span<const float> values, double origin, double step);

} // namespace ciel::wire
