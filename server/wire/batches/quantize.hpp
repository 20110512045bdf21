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

// The largest power of two that is no more than `wanted`, and no less than what floats as large as `largest` resolve:
// multiples of it up to there are floats, so quantized positions come back exactly.
[[nodiscard]] double grid_step(double wanted, double largest);

// The nearest multiple of `step`, off by half of it at most: the same for equal positions, whatever their batch.
[[nodiscard]] inline std::int32_t on_grid(float position, double inverse_step) {
    constexpr double most = 1 << 30;
    const double place = std::min(std::max(-most, position * inverse_step), most); // also where it is no number
    return static_cast<std::int32_t>(place < 0 ? place - 0.5 : place + 0.5);
}

// A unit vector on the octahedron |x| + |y| + |z| = 1, folded to a square of 255 x 255 places. Off by 0.34 degrees in
// the mean, 0.95 at most. (Cigolle et al., "A Survey of Efficient Representations for Independent Unit Vectors", 2014)
[[nodiscard]] std::array<std::int8_t, 2> octahedral(const Vec3f& normal);
[[nodiscard]] Vec3f from_octahedral(const std::array<std::int8_t, 2>& place);

inline constexpr std::uint32_t no_value = std::numeric_limits<std::uint32_t>::max(); // NaN

// value = origin + step * (low + place); `low` is the least of the batch.
struct QuantizedValues {
    std::int64_t low = 0;
    std::vector<std::uint32_t> places;
};
// Off by half a step at most up to 2^30 steps from `origin`, where larger ones end. NaN becomes no_value.
[[nodiscard]] QuantizedValues quantized(std::span<const float> values, double origin, double step);

} // namespace ciel::wire
