// Position on the three-dimensional Hilbert curve: neighbours in space become neighbours in memory.
// Not in the paper.
// Source: J. Skilling, Programming the Hilbert curve, AIP Conference Proceedings 707 (2004).
#pragma once

#include "ciel/types.hpp"

namespace ciel {

// `unit` is clamped to [0, 1]^3, NaN counts as 0. 21 bits per axis.
[[nodiscard]] std::uint64_t hilbert_key(Vec3d unit);

} // namespace ciel
