// The cell that contains a point, and the weights of the cell's vertices there. Not in the paper.
#pragma once

#include "ciel/cell_faces.hpp"

#include <array>
#include <utility>
#include <vector>

namespace ciel {

using VertexWeights = std::vector<std::pair<Index, double>>; // vertex, share; the shares sum to 1

// Reads the arrays of the mesh at each call; their owner must outlive the locator. Immutable, for any thread. Every
// function throws Error when an index leads out of the mesh.
class CellLocator {
public:
    // Reads the whole mesh once. Keeps the faces of each cell and one bounding box for every 128 cells.
    explicit CellLocator(const FaceMeshView& mesh);

    // Returns the cell that contains a position, or `none`. A cell contains a point if its faces wind around the point
    // (solid angles after Van Oosterom and Strackee 1983), so a cell need not be convex. Each face is a fan around its
    // centroid, the same fan for both of its cells, so cells have no gaps between them.
    [[nodiscard]] Index cell_at(const Vec3d& position) const;

    // Returns the weights of the cell's vertices at a position in the cell. They are linear in the tetrahedra (cell
    // centre, face centroid, edge), so they are exact for linear fields. A vertex may be listed more than once.
    [[nodiscard]] VertexWeights weights_in(Index cell, const Vec3d& position) const;

    // Returns the vertex of the cell that is nearest to a position.
    [[nodiscard]] Index nearest_vertex(Index cell, const Vec3d& position) const;

private:
    [[nodiscard]] std::vector<Index> vertices(Index cell) const;
    [[nodiscard]] double winding(Index cell, const Vec3d& at) const; // in units of 4 pi: 1 inside, 0 outside
    template <class Vertices>
    [[nodiscard]] Vec3d centroid(const Vertices& vertices) const;

    FaceMeshView mesh_;
    CellFaces faces_;
    std::vector<std::array<Vec3d, 2>> boxes_; // low and high corner around each run of 128 cells
};

} // namespace ciel
