// Surfaces without the polygons of cells that blew up: whose own value of an array is no number at a step.
#pragma once

#include "geometry/scene_geometry.hpp"

#include <span>

namespace ciel::geometry {

// `shape` itself where all of its polygons stay, and where it has none. Empty names are passed over. Throws
// store::NotWritten where an array was not written at the step.
[[nodiscard]] std::shared_ptr<const Shape> sound_shape(const std::shared_ptr<const Shape>& shape,
                                                       std::span<const std::string> arrays, std::size_t step,
                                                       store::LoadedDataset& loaded);

// "1 cell has no number for p at this time and is left out"; empty where all have. `is_cut`: the array's own surface,
// which leaves out cells that have a corner without a number, too.
[[nodiscard]] std::string left_out_text(const std::string& scalar, bool is_cut, std::size_t step,
                                        store::LoadedDataset& loaded);

} // namespace ciel::geometry
