// Surfaces without the polygons of cells that blew up: cells whose own value of an array is not a number at a step.
#pragma once

#include "geometry/scene_geometry.hpp"

#include <span>

namespace ciel::geometry {

// Returns `shape` itself if all its polygons stay, or if it has none. Empty names are ignored. Throws store::NotWritten
// if an array was not written at the step.
[[nodiscard]] std::shared_ptr<const Shape> sound_shape(const std::shared_ptr<const Shape>& shape,
                                                       std::span<const std::string> arrays, std::size_t step,
                                                       store::LoadedDataset& loaded);

// Returns "1 cell has no number for p at this time and is left out", or empty if every cell has one. `is_cut`: for
// geometry cut from the array itself, which also leaves out cells that have a corner without a number.
[[nodiscard]] std::string left_out_text(const std::string& scalar, bool is_cut, std::size_t step,
                                        store::LoadedDataset& loaded);

} // namespace ciel::geometry
