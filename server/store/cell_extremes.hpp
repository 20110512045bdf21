// Which cells have the lowest and the highest value: what interpolation to points never shows.
#pragma once

#include "store/dataset.hpp"

#include <optional>

namespace ciel::store {

struct CellValue {
    double value = 0;
    Index cell = none; // id of the imported file
    Vec3d place{};     // the mean of its corners
    double time = 0;   // of the step
};

struct LowestAndHighest {
    CellValue lowest, highest;
};

// Of a scalar of the cells, or of the points where it was made from the cells. Nothing where they are not known.
[[nodiscard]] std::optional<LowestAndHighest> cell_extremes(const store::Dataset& dataset, const std::string& scalar,
                                                            std::size_t step);
// Of the range of an array, as its steps have it: of its magnitude, of several components without one of all.
[[nodiscard]] std::optional<LowestAndHighest> range_extremes(const store::Dataset& dataset,
                                                             const store::ArrayInfo& array, std::size_t step);
[[nodiscard]] std::optional<LowestAndHighest> range_extremes(const store::Dataset& dataset,
                                                             const store::ArrayInfo& array); // of all steps

} // namespace ciel::store
