// Cell limits: [min, max] of the values at the vertices of each cell. Not in the paper.
#pragma once

#include "ciel/topology.hpp"

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace ciel {

// The limits of a cell that has none: low > high.
inline constexpr std::array<float, 2> no_limits{std::numeric_limits<float>::infinity(),
                                                -std::numeric_limits<float>::infinity()};

// Returns [min, max] of the values at the vertices of each cell, or no_limits if a value is NaN or infinite. `values`:
// one for each vertex. Throws Error when `values` has another size. Uses all threads of parallel_for.
[[nodiscard]] std::vector<std::array<float, 2>> cell_limits(const Topology& topology, std::span<const float> values);

} // namespace ciel
