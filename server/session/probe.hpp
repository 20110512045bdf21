// Values at a point.
#pragma once

#include "session/locator.hpp"
#include "session/picture.hpp"
#include "store/loaded.hpp"

#include <map>
#include <optional>
#include <string>

namespace ciel::session {

struct Probed {
    Vec3d position{};
    Index cell = none, vertex = none;                       // ids of the imported file; none outside of the mesh
    std::optional<std::int64_t> solver_cell, solver_vertex; // the solver's own, where the source has them
    std::map<std::string, std::optional<double>> values;    // nothing where not written at this step, or not a number
};

// Point scalars are interpolated in the cell; cell scalars are the cell's.
[[nodiscard]] Probed probe(const store::Dataset& dataset, std::size_t step, const Locator& locator, Vec3d position);

// The world position under a pixel (`check_wanted` as a frame's; from the top left) of the picture of this size;
// nothing on the background. A position on a boundary comes out of the depth buffer a little outside as often as
// inside: it is moved along the line of sight, by less than a pixel's depth error, to the nearest cell.
[[nodiscard]] std::optional<Vec3d> position_under(const Geometry& geometry, const scene::Scene& scene, ViewSize size,
                                                  std::array<double, 2> pixel, const Locator& locator, Worker& worker,
                                                  std::function<void()> check_wanted);

} // namespace ciel::session
