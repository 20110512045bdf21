// Computes what is stored about the values of an array at one step.
#pragma once

#include "store/dataset.hpp"
#include "store/format/value_ranges.hpp"

namespace ciel::store {

// Returns the ranges, and the cells at their ends. Leaves the places of the extremes zero; cell_places.hpp computes
// them.
[[nodiscard]] ArrayStep statistics(ValuesView values, const ArrayInfo& array);

// Returns the ranges, histograms and page checksums that are stored beside the values. `topology`: of the array's mesh.
[[nodiscard]] ValueRanges value_ranges(ValuesView values, const ArrayInfo& array, const Topology& topology);

} // namespace ciel::store
