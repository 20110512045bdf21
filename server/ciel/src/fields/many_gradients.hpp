// Computes the gradients in many standard cells of one type (paper, section 3), four at a time. The bits are those of
// standard_gradient.
#pragma once

#include "fields/cell_gradient.hpp"

#include <cstdint>
#include <span>

namespace ciel {

// Sets one gradient per cell. type: of a standard cell. `vertex`: for each cell, the indices of its corners in
// `sample`.
void many_gradients(CellType type, std::span<const std::uint16_t> vertex, std::span<const Sample> sample,
                    std::span<CellGradient> out);

} // namespace ciel
