// CellLocator: finds the cell that contains a point, and interpolation weights of the cell's vertices at the point. Not
// in the paper.
#pragma once

#include "ciel/block_ranges.hpp"
#include "ciel/face_mesh.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace ciel {

using VertexWeights = std::vector<std::pair<Index, double>>; // (vertex, weight); the weights sum to 1

// Immutable; any thread may use it. A call reads only blocks whose box contains the position, or the block of the given
// cell. A locator is cheap to make: it has no search structure of its own, and keeps no results between calls. Every
// function throws Error when a record or a position cannot be read.
class CellLocator {
public:
    // `points`: the mesh of the topology; its faces are not used. `boxes`: the result of block_boxes for the positions
    // of `points`. Throws Error when the numbers of vertices or blocks of the arguments differ, and when `points` has
    // no owner.
    CellLocator(const Topology& topology, const FaceMeshView& points, std::shared_ptr<const BlockBoxes> boxes);

    // Returns the cell that contains `position` (in the mesh's coordinates), or `none`. A cell contains a point if the
    // solid angles of the cell's faces around the point sum to 4 pi (Van Oosterom and Strackee 1983). Therefore a cell
    // need not be convex. A point on the boundary of several cells belongs to the cell with the largest sum. Each face
    // is triangulated around its centroid, in the same way for both of its cells, so that there are no gaps between
    // cells.
    [[nodiscard]] Index cell_at(const Vec3d& position) const;

    // Returns the weights of the cell's vertices at a position in the cell. For each edge of each face, the cell has
    // one tetrahedron: the two ends of the edge, the centroid of the face and the center of the cell. The weights are
    // linear in each tetrahedron, so that they are exact for linear fields. A vertex may be listed more than once. In a
    // cell with bent faces, weights may be below 0. At the position of a vertex, and in a cell without volume, one
    // vertex alone is listed, with the weight 1: the nearest one, or the lowest id of several there. Throws Error when
    // the cell does not exist.
    [[nodiscard]] VertexWeights weights_in(Index cell, const Vec3d& position) const;

    // Returns the vertex of the cell that is nearest to `position`. Throws Error when the cell does not exist.
    [[nodiscard]] Index nearest_vertex(Index cell, const Vec3d& position) const;

private:
    Topology topology_;
    FaceMeshView points_;
    std::shared_ptr<const BlockBoxes> boxes_;
};

} // namespace ciel
