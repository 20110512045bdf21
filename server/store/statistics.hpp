// Computes the ranges, extremes, histograms and checksums that are stored for an array at one step.
#pragma once

#include "store/dataset.hpp"
#include "store/format/value_ranges.hpp"

namespace ciel::store {

// Returns the ranges of the values and, for an array on cells, the cells at the ends of the ranges. Leaves the
// positions of these cells zero; the caller computes them with cell_places.
[[nodiscard]] ArrayStep statistics(ValuesView values, const ArrayInfo& array);

// Returns the ranges, histograms and page checksums that are stored beside the values. `topology`: the topology of the
// array's mesh.
[[nodiscard]] ValueRanges value_ranges(ValuesView values, const ArrayInfo& array, const Topology& topology);

} // namespace ciel::store
