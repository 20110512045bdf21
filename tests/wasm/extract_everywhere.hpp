// The same work on every machine that the kernel is compiled for.
#pragma once

#include "wasm/bytes.hpp"

namespace ciel::test {

// Takes each case (cases.hpp) through all of the kernel: assembly, operators, every algorithm, decider and kind of
// normals, changed fields, moved vertices, sweeps into every sink, thresholds, clipped surfaces, contour lines and
// edges. The results are pairs of a name, "mesh / field / algorithm at value / array", and the array's raw bytes.
[[nodiscard]] Bytes extract_everywhere(std::span<const std::byte> cases);

} // namespace ciel::test
