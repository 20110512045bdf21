// The cell that contains a point, and the weights of the cell's vertices there. Not in the paper.
#pragma once

#include "ciel/block_ranges.hpp"
#include "ciel/face_mesh.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace ciel {

using VertexWeights = std::vector<std::pair<Index, double>>; // vertex, share; the shares sum to 1

// Immutable, for any thread. Each call reads the blocks whose box holds the position, and their vertices. Nothing is
// kept between calls, so a locator costs nothing to make. Every function throws Error when a record or a position
// cannot be read.
class CellLocator {
public:
    // points: the mesh of the topology, with or without faces. boxes: what block_boxes returned for its positions. The
    // topology and what `points` views must outlive the locator.
    CellLocator(const Topology& topology, const FaceMeshView& points, std::shared_ptr<const BlockBoxes> boxes);

    // Returns the cell that contains a position, or `none`. A cell contains a point if its faces wind around the point
    // (solid angles after Van Oosterom and Strackee 1983), so a cell need not be convex. Each face is a fan around its
    // centroid, the same fan for both of its cells, so cells have no gaps between them.
    [[nodiscard]] Index cell_at(const Vec3d& position) const;

    // Returns the weights of the cell's vertices at a position in the cell. The cell is divided into one tetrahedron
    // per edge of a face: the ends of the edge, the centroid of the face and the center of the cell. The weights are
    // linear in each tetrahedron, so they are exact for linear fields. A vertex may be listed more than once.
    [[nodiscard]] VertexWeights weights_in(Index cell, const Vec3d& position) const;

    // Returns the vertex of the cell that is nearest to a position.
    [[nodiscard]] Index nearest_vertex(Index cell, const Vec3d& position) const;

private:
    const Topology* topology_;
    FaceMeshView points_;
    std::shared_ptr<const BlockBoxes> boxes_;
};

} // namespace ciel
