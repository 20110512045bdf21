// Weights of values around a place, exact for linear fields along the directions in which the values surround it. At a
// boundary no values lie beyond it along the normal. In a mesh of one layer of cells none lie across the thickness.
// Such directions are left out: weights that had to be exact along them would not be exact along any. Not in the paper.
// This work is based on: D. G. Holmes, S. D. Connell, Solution of the 2D Navier-Stokes equations on unstructured
// adaptive grids, AIAA 89-1932, 1989 (the pseudo-Laplacian and its clipped weights).
#pragma once

#include "ciel/vectors.hpp"

#include <span>
#include <vector>

namespace ciel {

// Collects the boundary normals at a place and merges similar ones.
class LeftOutDirections {
public:
    // Longer normals weigh more. The sign of a normal is ignored.
    void add(Vec3d normal);
    // Returns at most three orthogonal unit vectors.
    [[nodiscard]] std::vector<Vec3d> directions() const;

private:
    std::array<Vec3d, 3> sums_{};
    int count_ = 0;
};

// Returns `v` without its components along `directions`, which are orthogonal unit vectors.
[[nodiscard]] Vec3d without_parts_along(std::span<const Vec3d> directions, Vec3d v);

// Sets `weights` for values at `displacements` from the place: each >= 0, sum 1. Removes the components along
// `left_out` from `displacements`.
void linear_weights(std::span<Vec3d> displacements, std::span<const Vec3d> left_out, std::span<double> weights);

} // namespace ciel
