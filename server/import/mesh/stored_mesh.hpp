// The mesh of a dataset as a StepMesh, so that values of another step can be stored without matching cells.
#pragma once

#include "import/mesh/step_mesh.hpp"
#include "store/dataset.hpp"

#include <optional>

namespace server::importer {

// REQUIRES: `input_grids` have the fingerprint of the first mesh of the dataset, and that mesh was written from a
// StepMesh with may_be_stored_mesh. The result has no notes, groups and counts. Returns nullopt if the ids of the
// dataset do not fit the numbers of points and cells. Throws Error if the dataset is damaged.
[[nodiscard]] std::optional<StepMesh> stored_mesh(const store::Dataset& dataset, const InputGrids& input_grids);

} // namespace server::importer
