// Position on the three-dimensional Hilbert curve. If cells are sorted by this position, cells that are close in space
// are also close in memory. Not in the paper.
// The method is from J. Skilling, Programming the Hilbert curve, AIP Conference Proceedings 707 (2004).
#pragma once

#include "ciel/types.hpp"

namespace ciel::detail {

// The key has 21 bits per axis. `unit` is clamped to [0, 1]^3; NaN is treated as 0.
[[nodiscard]] std::uint64_t hilbert_key(Vec3d unit);

} // namespace ciel::detail
