// Converts cell values to point values: weighted means over the cells around each vertex (linear_weights.hpp). The
// means are exact for linear fields if the cell centers surround the vertex; at a boundary vertex, for linear fields
// that do not vary along the normal. They never leave the range of the cell values. Not in the paper.
#pragma once

#include "ciel/face_mesh.hpp"

#include <span>
#include <vector>

namespace ciel {

// Weights of the cells around each vertex of a mesh. Only cells that have the vertex count, so values of regions that
// are not welded do not mix. The constructor throws Error when the mesh holds an index that is out of range.
class PointInterpolation {
public:
    explicit PointInterpolation(const FaceMeshView& mesh);

    // Converts `components` interleaved values per cell to as many per vertex. Values that are not finite are left out
    // of the means. A vertex without any finite value gets NaN.
    [[nodiscard]] std::vector<float> apply(std::span<const float> cell_values, int components) const;
    [[nodiscard]] std::vector<double> apply(std::span<const double> cell_values, int components) const;

private:
    void find_cells(const FaceMeshView& mesh);
    template <class T>
    [[nodiscard]] std::vector<T> apply_to(std::span<const T> cell_values, int components) const;

    std::vector<std::uint64_t> offset_; // per vertex and one more: first entry in cell_ and weight_
    std::vector<Index> cell_;
    std::vector<float> weight_; // of the cell at this vertex: >= 0; the sum at a vertex is 1
};

} // namespace ciel
