// Interpolation weights for values at scattered positions around a point. The interpolation is exact for linear fields
// if the positions surround the point. At a boundary they do not surround it along the normal, and in a mesh of one
// layer of cells not across the layer. The caller leaves these directions out, and the interpolation is exact along the
// others. Not in the paper.
// This work is based on: D. G. Holmes, S. D. Connell, Solution of the 2D Navier-Stokes equations on unstructured
// adaptive grids, AIAA 89-1932, 1989 (the pseudo-Laplacian and its clipped weights).
#pragma once

#include "ciel/vectors.hpp"

#include <span>
#include <vector>

namespace ciel {

// Collects the normals of the boundary faces at a point and merges those within 37 degrees of each other.
class LeftOutDirections {
public:
    // The length of the normal is its weight. Its sign is ignored.
    void add(Vec3d normal);
    // Returns at most three orthogonal unit vectors.
    [[nodiscard]] std::vector<Vec3d> directions() const;

private:
    std::array<Vec3d, 3> sums_{};
    int count_ = 0;
};

// Returns `v` without its components along `directions`, which are orthogonal unit vectors.
[[nodiscard]] Vec3d without_parts_along(std::span<const Vec3d> directions, Vec3d v);

// Writes the weights of values whose positions are at `displacements` from the point. Each weight is >= 0, their sum
// is 1. `left_out` are orthogonal unit vectors; their components are removed from `displacements`.
void linear_weights(std::span<Vec3d> displacements, std::span<const Vec3d> left_out, std::span<double> weights);

} // namespace ciel
