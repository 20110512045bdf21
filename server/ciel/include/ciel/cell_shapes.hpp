// The shapes of the faces of each cell, and the centroids of cells. Not in the paper.
#pragma once

#include "ciel/cell_geometry.hpp"
#include "ciel/matched_cells.hpp"
#include "ciel/topology.hpp"

#include <functional>

namespace ciel {

// `faces`: the faces of the cell; the areas point out of the cell. `center`: its centroid, as an offset from the mesh's
// origin.
using OnCell = std::function<void(Index cell, std::span<const FaceShape> faces, const Vec3d& center)>;

// Call visit(cell, faces, center) for each cell. Several threads may call `visit` at the same time, for different
// cells. `faces` is valid only during the call, because shapes are not kept. `points`: the positions of the mesh's
// vertices; must be loaded. Use all threads of parallel_for. Throw Error when `points` has another number of vertices,
// or when a record is damaged.
void for_cell_shapes(const MatchedCells& cells, const FaceMeshView& points, const OnCell& visit);
void for_cell_shapes(const Topology& topology, const FaceMeshView& points, const OnCell& visit);

// Returns the centroids of all cells, by cell id. Throws Error as for_cell_shapes does.
[[nodiscard]] std::vector<Vec3d> cell_centers(const Topology& topology, const FaceMeshView& points);

} // namespace ciel
