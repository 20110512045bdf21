// Computes the gradients in many standard cells of one type (paper, section 3), four at a time. The results are bit for
// bit equal to the results of standard_gradient.
#pragma once

#include "fields/cell_gradient.hpp"

#include <cstdint>
#include <span>

namespace ciel {

// Sets `out` to one gradient per cell. `type`: the standard type of all cells. `vertex`: for each cell, the indices of
// its corners in `sample`.
void many_gradients(CellType type, std::span<const std::uint16_t> vertex, std::span<const Sample> sample,
                    std::span<CellGradient> out);

} // namespace ciel
