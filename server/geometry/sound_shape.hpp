// Surfaces without the polygons of cells that are not sound. A cell is not sound if the solver's result for an array in
// the cell is NaN or infinite at a step (LoadedDataset::sound_cells).
#pragma once

#include "geometry/scene_geometry.hpp"

#include <span>

namespace server::geometry {

// Returns `shape` without the polygons of cells that are not sound for one of the arrays. Returns `shape` itself if no
// polygon is left out. Empty names are ignored. Throws store::NotWritten if an array was not written at the step.
[[nodiscard]] std::shared_ptr<const Shape> sound_shape(const std::shared_ptr<const Shape>& shape,
                                                       std::span<const std::string> arrays, std::size_t step,
                                                       store::LoadedDataset& loaded);

// Returns "1 cell has no number for p at this time and is left out", or an empty text if every cell has a number.
// `is_cut`: the geometry is a cut of this array. Such a cut also leaves out cells that have a corner without a number.
[[nodiscard]] std::string left_out_text(const std::string& scalar, bool is_cut, std::size_t step,
                                        store::LoadedDataset& loaded);

} // namespace server::geometry
