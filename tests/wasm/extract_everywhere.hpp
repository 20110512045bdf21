// The extraction that every machine runs, for comparison bit by bit.
#pragma once

#include "wasm/bytes.hpp"

namespace ciel::test {

// Runs each case (cases.hpp) through the whole kernel: assembly, operators, every algorithm, decider and normal rule,
// changed fields, moved vertices, sweeps into every sink, thresholds, clipped surfaces, contour lines and edges.
// Returns pairs of a name, "mesh / field / algorithm at value / array", and the array's bytes.
[[nodiscard]] Bytes extract_everywhere(std::span<const std::byte> cases);

} // namespace ciel::test
