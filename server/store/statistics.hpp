// Computes the ranges of an array at one step, and the cells at their ends.
#pragma once

#include "store/dataset.hpp"

namespace ciel::store {

// Leaves the places of the extremes zero; cell_places.hpp computes them.
[[nodiscard]] ArrayStep statistics(ValuesView values, const ArrayInfo& array);

} // namespace ciel::store
