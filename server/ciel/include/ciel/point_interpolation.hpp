// Converts cell values to point values. A point value is a weighted mean of the values of the cells around the vertex
// (linear_weights.hpp), and so never leaves the range of these values. The mean is exact for linear fields if the cell
// centers surround the vertex. At a boundary vertex, it is exact for linear fields that do not vary along the normal.
// Not in the paper.
#pragma once

#include "ciel/topology.hpp"

#include <span>
#include <vector>

namespace ciel {

// The weights of the cells around each vertex of a mesh. Only cells that have the vertex contribute. Therefore values
// do not mix between regions of the mesh that share no vertices. The constructor throws Error when a record is damaged
// or an index of the mesh is out of range, and uses all threads of parallel_for.
class PointInterpolation {
public:
    // `boundary`: has the positions of the topology's vertices, and the boundary faces of the mesh. The positions must
    // be loaded. Other faces are ignored.
    PointInterpolation(const Topology& topology, const FaceMeshView& boundary);

    // Converts cell values to point values. `cell_values`: `components` interleaved values for each cell. REQUIRES:
    // `cell_values` has values for all cells, and components >= 1. Returns `components` interleaved values for each
    // vertex. A mean leaves out values that are not finite. A vertex without any finite value gets NaN. Uses all
    // threads of parallel_for.
    [[nodiscard]] std::vector<float> apply(std::span<const float> cell_values, int components) const;
    [[nodiscard]] std::vector<double> apply(std::span<const double> cell_values, int components) const;
    // Like apply(), but writes the point values to `points`. Throws Error unless `points` has `components` values for
    // each vertex.
    template <class T> // float or double
    void apply_into(std::span<const T> cell_values, int components, std::span<T> points) const;

private:
    struct CellAtVertex;
    [[nodiscard]] static std::vector<CellAtVertex> at_collapsed_faces(const Topology& topology,
                                                                      const FaceMeshView& mesh);
    void find_cells(const Topology& topology, std::span<const CellAtVertex> further);

    std::vector<std::uint64_t> offset_; // V + 1: first entry of each vertex in cell_ and weight_
    std::vector<Index> cell_;
    std::vector<float> weight_; // weights of the cells of a vertex: >= 0, with the sum 1
};

} // namespace ciel
