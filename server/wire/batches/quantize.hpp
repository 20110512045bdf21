// Positions, normals and values as the small integers that polygon batches carry (protocol/frame.md).
#pragma once

#include "ciel/types.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace server::wire {

// Returns the largest power of two that is at most `wanted`, but at least the spacing of floats at `largest`. Multiples
// of this step up to `largest` are exact floats, so that quantized positions are decoded without rounding.
[[nodiscard]] double grid_step(double wanted, double largest);

// Rounds to the nearest step. Equal positions get equal coordinates in all batches.
[[nodiscard]] inline std::int32_t on_grid(float position, double inverse_step) {
    constexpr double most = 1 << 30;
    const double place = std::min(std::max(-most, position * inverse_step), most); // NaN becomes -most
    return static_cast<std::int32_t>(place < 0 ? place - 0.5 : place + 0.5);
}

// Maps a unit vector to the octahedron |x| + |y| + |z| = 1, which is folded to a square of 255 x 255 points.
// from_octahedral() is the inverse. The mean error is 0.34 degrees, the largest error 0.95 degrees. (Cigolle et al., "A
// Survey of Efficient Representations for Independent Unit Vectors", 2014)
[[nodiscard]] std::array<std::int8_t, 2> octahedral(const ciel::Vec3f& normal);
[[nodiscard]] ciel::Vec3f from_octahedral(const std::array<std::int8_t, 2>& place);

// Marks a NaN in QuantizedValues::places.
inline constexpr std::uint32_t no_value = std::numeric_limits<std::uint32_t>::max();

// Value i = origin + step * (low + places[i]). `low` is the smallest value, in steps from the origin.
struct QuantizedValues {
    std::int64_t low = 0;
    std::vector<std::uint32_t> places;
};
// The error is at most half a step. Values are clamped to 2^30 steps from `origin`. NaN becomes no_value.
[[nodiscard]] QuantizedValues quantized(std::span<const double> values, double origin, double step);

} // namespace server::wire
