// Point data from cell data: a weighted mean of the cells around each vertex (linear_weights.hpp). It is exact for
// linear fields where the cell centres surround the vertex; on the boundary it is exact along the boundary. It never
// leaves the range of the cell values. Not in the paper.
#pragma once

#include "ciel/face_mesh.hpp"

#include <span>
#include <vector>

namespace ciel {

// Cells that share no vertex never mix: unwelded regions stay apart. Throws Error when an index leads out of the mesh.
class PointInterpolation {
public:
    explicit PointInterpolation(const FaceMeshView& mesh);

    // Converts `components` values per cell to as many per vertex. Values that are not finite are left out of the
    // means; NaN where no value remains.
    [[nodiscard]] std::vector<float> apply(std::span<const float> cell_values, int components) const;

private:
    void find_cells(const FaceMeshView& mesh);

    std::vector<std::uint64_t> offset_; // V + 1
    std::vector<Index> cell_;
    std::vector<float> weight_; // >= 0, sum 1 per vertex
};

} // namespace ciel
