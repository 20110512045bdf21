// Finds the values of all arrays at a point.
#pragma once

#include "store/loaded.hpp"

#include <map>
#include <optional>
#include <string>

namespace server::probe {

struct Probed {
    ciel::Vec3d position{};                                 // world coordinates, as given to probe()
    ciel::Index cell = ciel::none, vertex = ciel::none;     // ids of the imported file; `none` outside the mesh
    std::optional<std::int64_t> solver_cell, solver_vertex; // ids of the solver, if the imported file has them
    std::map<std::string, std::optional<double>> values; // by scalar; nullopt if not written at this step or not finite
};

// Point scalars are interpolated in the cell. Reads only the stretches (store/format/checksum.hpp) that have the
// values. `locator`: locator of the mesh, with the coordinates of the step. Throws Error when a file is damaged.
[[nodiscard]] Probed probe(const store::Dataset& dataset, std::size_t step, const ciel::CellLocator& locator,
                           ciel::Vec3d position);

} // namespace server::probe
