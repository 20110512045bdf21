// A box of 6 x 6 x 6 with cells of every kind, far from the origin, with point and cell arrays, patches, a zone, three
// steps and an array that is written late.
#pragma once

#include "ciel/types.hpp"
#include "support/folder.hpp"

#include <filesystem>

namespace ciel::test {

inline constexpr double box_edge = 6;
inline constexpr Vec3d box_origin{1000, 0, -50};

// The values of the arrays; `at` is an offset from box_origin.
inline double pressure(const Vec3d& at, double time) { return at[0] + 2 * at[1] + 3 * at[2] + 10 * time; }
inline Vec3d velocity(const Vec3d& at) { return {at[2], 1, -at[0]}; }

// Point arrays p (written at all steps), U (3 components) and late (= p, at time 2 only), cell array "cell:q" (the
// imported cell's id) at times 0, 1, 2; the patches "left" (x = 0) and "body" (the sides of a hole in the middle); the
// cell zone "half".
void write_small_dataset(const std::filesystem::path& directory);
// One more step, as a running simulation would add it.
void append_step(const std::filesystem::path& directory, double time);

} // namespace ciel::test
