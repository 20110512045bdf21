// Interpolation weights for values at scattered positions around a point. The interpolation is exact for linear fields
// if the positions surround the point. At a boundary, the positions do not surround the point along the normal. In a
// mesh of one layer of cells, they do not surround the point across the layer. The caller leaves these directions out
// (`left_out`). The interpolation is then exact for linear fields that do not vary along the directions left out. Not
// in the paper. Source: D. G. Holmes, S. D. Connell, Solution of the 2D Navier-Stokes equations on unstructured
// adaptive grids, AIAA 89-1932, 1989 (the pseudo-Laplacian and its clipped weights).
#pragma once

#include "ciel/vectors.hpp"

#include <span>
#include <vector>

namespace ciel {

// Directions to leave out at a point: collects the normals of the boundary faces around the point, and merges normals
// within 37 degrees of each other.
class LeftOutDirections {
public:
    // The length of `normal` is its weight. The sign of `normal` is ignored.
    void add(Vec3d normal);
    // Returns the directions to leave out: at most three orthogonal unit vectors.
    [[nodiscard]] std::vector<Vec3d> directions() const;

private:
    std::array<Vec3d, 3> sums_{};
    int count_ = 0;
};

// Returns `v` without its components along `directions`, which are orthogonal unit vectors.
[[nodiscard]] Vec3d without_parts_along(std::span<const Vec3d> directions, Vec3d v);

// Sets weights[i] to the weight of the value at the offset displacements[i] from the point. Each weight is >= 0, and
// the sum is 1. `left_out`: orthogonal unit vectors; the components along them are removed from `displacements`. If a
// displacement is not finite, all weights are equal. REQUIRES: `weights` and `displacements` have the same number of
// entries, at least one.
void linear_weights(std::span<Vec3d> displacements, std::span<const Vec3d> left_out, std::span<double> weights);

} // namespace ciel
