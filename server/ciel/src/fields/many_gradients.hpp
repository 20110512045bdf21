// Gradients in many standard cells (paper, section 3), bit for bit equal to the results of standard_gradient.
#pragma once

#include "fields/cell_gradient.hpp"

#include <cstdint>
#include <span>

namespace ciel::detail {

// `type`: the standard type of all cells. `vertex`: for each cell, the indices of its corners in `sample`.
void many_gradients(CellType type, std::span<const std::uint16_t> vertex, std::span<const Sample> sample,
                    std::span<CellGradient> out);

} // namespace ciel::detail
