// Values at a point.
#pragma once

#include "store/loaded.hpp"

#include <map>
#include <optional>
#include <string>

namespace ciel::probe {

struct Probed {
    Vec3d position{};
    Index cell = none, vertex = none;                       // ids of the imported file; none outside of the mesh
    std::optional<std::int64_t> solver_cell, solver_vertex; // the solver's own, where the source has them
    std::map<std::string, std::optional<double>> values;    // nothing where not written at this step, or not a number
};

// Point scalars are interpolated in the cell; cell scalars are the cell's. Reads the pages of these values. `locator`:
// of the mesh and the coordinates of the step. Throws Error when a file is damaged.
[[nodiscard]] Probed probe(const store::Dataset& dataset, std::size_t step, const CellLocator& locator, Vec3d position);

} // namespace ciel::probe
