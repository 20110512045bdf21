// Computes the ranges, extremes, histograms and checksums that are stored for an array at one step.
#pragma once

#include "store/dataset.hpp"
#include "store/format/value_ranges.hpp"

namespace ciel::store {

// Leaves the positions of the cells in `extremes` zero; the caller computes them with cell_places.
[[nodiscard]] ArrayStep statistics(ValuesView values, const ArrayInfo& array);

[[nodiscard]] ValueRanges value_ranges(ValuesView values, const ArrayInfo& array, const Topology& topology);

} // namespace ciel::store
