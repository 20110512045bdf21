// Point data from cell data: a weighted mean of the cells around each vertex that is exact for linear fields wherever
// their centres surround the vertex, and never leaves the range of their values. Not in the paper.
// This work is based on: D. G. Holmes, S. D. Connell, Solution of the 2D Navier-Stokes equations on unstructured
// adaptive grids, AIAA 89-1932, 1989 (the pseudo-Laplacian and its clipped weights).
#pragma once

#include "ciel/face_mesh.hpp"

#include <span>
#include <vector>

namespace ciel {

// Cells that share no vertex never mix: unwelded regions stay apart. Throws Error when an index leads out of the mesh.
class PointInterpolation {
public:
    explicit PointInterpolation(const FaceMeshView& mesh);

    // components values per cell -> per vertex. Values that are not finite are left out of the means; NaN where nothing
    // remains.
    [[nodiscard]] std::vector<float> apply(std::span<const float> cell_values, int components) const;

private:
    void find_cells(const FaceMeshView& mesh);
    void find_weights(const FaceMeshView& mesh, std::span<const Vec3d> centres, std::size_t vertex);

    std::vector<std::uint64_t> offset_; // V + 1
    std::vector<Index> cell_;
    std::vector<float> weight_; // >= 0, sum 1 per vertex
};

} // namespace ciel
