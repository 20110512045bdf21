// A small dataset: a box of 6 x 6 x 6 with all kinds of cells, far from the origin, with arrays, patches, a zone and
// three steps.
#pragma once

#include "ciel/types.hpp"
#include "support/folder.hpp"

#include <filesystem>

namespace ciel::test {

inline constexpr double box_edge = 6;
inline constexpr Vec3d box_origin{1000, 0, -50};

// Returns the offset from box_origin of a position that is relative to `origin`.
inline Vec3d in_box(const Vec3d& origin, const Vec3f& position) {
    return {origin[0] + position[0] - box_origin[0], origin[1] + position[1] - box_origin[1],
            origin[2] + position[2] - box_origin[2]};
}

// Exact values of the arrays. `at` is an offset from box_origin.
inline double pressure(const Vec3d& at, double time) { return at[0] + 2 * at[1] + 3 * at[2] + 10 * time; }
inline Vec3d velocity(const Vec3d& at) { return {at[2], 1, -at[0]}; }

// Writes the dataset with times 0, 1, 2:
// Point arrays p (all times), U (3 components), late (equal to p, only at time 2). Cell array "cell:q": the imported
// cell's id.
// Patches "left" (x = 0) and "body" (the sides of the hole in the middle). Cell zone "half".
void write_small_dataset(const std::filesystem::path& directory);
// Appends a step, as a running simulation would.
void append_step(const std::filesystem::path& directory, double time);

} // namespace ciel::test
