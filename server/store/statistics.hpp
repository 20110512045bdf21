// Computes the ranges, extremes, histograms and checksums that are stored for an array at one step.
#pragma once

#include "store/dataset.hpp"
#include "store/format/value_ranges.hpp"

namespace server::store {

// Leaves the positions of the cells in `extremes` zero; the caller computes them with cell_places.
[[nodiscard]] ArrayStep statistics(ciel::ValuesView values, const ArrayInfo& array);

[[nodiscard]] ValueRanges value_ranges(ciel::ValuesView values, const ArrayInfo& array, const ciel::Topology& topology);

} // namespace server::store
