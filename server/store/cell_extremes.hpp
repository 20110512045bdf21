// Finds the cells with the lowest and the highest value. Interpolated point values lie between these two values.
#pragma once

#include "store/dataset.hpp"

#include <optional>

namespace server::store {

struct CellValue {
    double value = 0;
    ciel::Index cell = ciel::none; // id of the cell in the imported file
    ciel::Vec3d place{};           // mean of the cell's corners, in the dataset's coordinates
    double time = 0;
};

struct LowestAndHighest {
    CellValue lowest, highest;
};

// Returns the cells with the lowest and the highest value of a scalar. For a point scalar that was interpolated from
// cells, uses the scalar on cells. Returns nullopt if the dataset does not store these cells.
[[nodiscard]] std::optional<LowestAndHighest> cell_extremes(const store::Dataset& dataset, const std::string& scalar,
                                                            std::size_t step);
// Return the cells whose values are the ends of ArrayStep::range. This is the range of the magnitudes, or of all
// components if the array has no magnitude. The second overload searches all steps. Both return nullopt if the dataset
// does not store these cells.
[[nodiscard]] std::optional<LowestAndHighest> range_extremes(const store::Dataset& dataset,
                                                             const store::ArrayInfo& array, std::size_t step);
[[nodiscard]] std::optional<LowestAndHighest> range_extremes(const store::Dataset& dataset,
                                                             const store::ArrayInfo& array);

} // namespace server::store
