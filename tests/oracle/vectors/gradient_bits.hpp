// Gradients of random cells. gradient_bits.cpp is compiled twice: as the kernel is, and with plain vectors in the
// namespace ciel_plain (CMakeLists.txt).
#pragma once

#include <cstdint>
#include <vector>

namespace ciel::test {

// Returns the bits of the gradients and volumes, by all functions of the kernel for cells. `type`: a standard CellType.
[[nodiscard]] std::vector<std::uint64_t> gradient_bits(std::uint8_t type);

} // namespace ciel::test

namespace ciel_plain::test {

[[nodiscard]] std::vector<std::uint64_t> gradient_bits(std::uint8_t type);

} // namespace ciel_plain::test
