// Finds the cells with the lowest and the highest value of an array. Point values that are interpolated from the array
// lie between these two.
#pragma once

#include "store/dataset.hpp"

#include <optional>

namespace ciel::store {

struct CellValue {
    double value = 0;
    Index cell = none; // id of the cell in the imported file
    Vec3d place{};     // mean of the cell's corners, in the dataset's coordinates
    double time = 0;   // time of the step
};

struct LowestAndHighest {
    CellValue lowest, highest;
};

// Returns the extremes of a scalar on cells, or of the scalar on cells that a point scalar was interpolated from.
// Returns nullopt if they are not known.
[[nodiscard]] std::optional<LowestAndHighest> cell_extremes(const store::Dataset& dataset, const std::string& scalar,
                                                            std::size_t step);
// Returns the cells at the ends of ArrayStep::range: of the magnitude, or of all components of an array without
// magnitude. The second overload searches all steps. Both return nullopt if the cells are not known.
[[nodiscard]] std::optional<LowestAndHighest> range_extremes(const store::Dataset& dataset,
                                                             const store::ArrayInfo& array, std::size_t step);
[[nodiscard]] std::optional<LowestAndHighest> range_extremes(const store::Dataset& dataset,
                                                             const store::ArrayInfo& array);

} // namespace ciel::store
