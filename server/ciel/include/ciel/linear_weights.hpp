// Weights of values around a place, exact for linear fields along the directions in which the values surround it. On a
// boundary no values lie beyond its normal, and in a mesh of one layer of cells none across its thickness. Such
// directions are left out: weights that had to be exact along them would not be exact along any. Not in the paper. This
// work is based on: D. G. Holmes, S. D. Connell, Solution of the 2D Navier-Stokes equations on unstructured adaptive
// grids, AIAA 89-1932, 1989 (the pseudo-Laplacian and its clipped weights).
#pragma once

#include "ciel/vectors.hpp"

#include <span>
#include <vector>

namespace ciel {

// The normals of what bounds a place, near ones taken together.
class LeftOutDirections {
public:
    // Longer ones count for more; either side is the same.
    void add(Vec3d normal);
    // Orthogonal and of length 1: at most three.
    [[nodiscard]] std::vector<Vec3d> directions() const;

private:
    std::array<Vec3d, 3> sums_{};
    int count_ = 0;
};

// `v` without its parts along `directions`, which are orthogonal and of length 1.
[[nodiscard]] Vec3d without_parts_along(std::span<const Vec3d> directions, Vec3d v);

// For values at these displacements from the place: weights >= 0 whose sum is 1. `displacements` lose their parts along
// `left_out`.
void linear_weights(std::span<Vec3d> displacements, std::span<const Vec3d> left_out, std::span<double> weights);

} // namespace ciel
