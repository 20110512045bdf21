// The caller's points: as floats if all floats are equal to the caller's numbers, else as doubles. Not in the paper.
#pragma once

#include "ciel/array_view.hpp"
#include "ciel/values_view.hpp"

#include <span>
#include <vector>

namespace ciel::detail {

struct MeshPoints {
    std::vector<float> floats; // V x 3; `floats` or `doubles` is empty
    std::vector<double> doubles;

    [[nodiscard]] ValuesView view() const { return doubles.empty() ? ValuesView(floats) : ValuesView(doubles); }
};

// Returns the rows of `points` (V x 3) whose indices are in `order`, in this order; all rows if `order` is empty.
[[nodiscard]] MeshPoints mesh_points(const ArrayView& points, std::span<const Index> order = {});

// Returns the middle of the bounding box of the finite points, or zero if there are none.
[[nodiscard]] Vec3d middle_of(const ArrayView& points);

} // namespace ciel::detail
