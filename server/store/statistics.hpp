// Ranges of an array at one step, and the cells that have the ends of them.
#pragma once

#include "store/dataset.hpp"

namespace ciel::store {

// Without the places of the extremes: cell_places.hpp.
[[nodiscard]] ArrayStep statistics(std::span<const float> values, const ArrayInfo& array);

} // namespace ciel::store
