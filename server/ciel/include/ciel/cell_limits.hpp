// Cell limits: [min, max] of the values at the vertices of a cell. Not in the paper.
#pragma once

#include "ciel/topology.hpp"

#include <array>
#include <limits>
#include <span>
#include <utility>

namespace ciel {

// Stands for a cell without limits: low > high.
inline constexpr std::array<float, 2> no_limits{std::numeric_limits<float>::infinity(),
                                                -std::numeric_limits<float>::infinity()};

// Computes the limits of one cell in each call, because an array of all limits would be as long as the mesh. Not
// thread-safe; an object is small, so each thread makes its own.
class CellLimits {
public:
    explicit CellLimits(Topology topology) : topology_(std::move(topology)) {}
    // Returns [min, max] of the values at the vertices of the cell, or no_limits if a value is NaN or infinite, or if
    // the cell has no faces. `values`: one for each vertex. Faster if the cell of the previous call is in the same
    // block. Throws Error when `values` has another size or the mesh has no such cell, and when a record is damaged.
    [[nodiscard]] std::array<float, 2> of(Index cell, std::span<const float> values);

private:
    Topology topology_;
    Index block_ = 0, cell_begin_ = 0, cell_end_ = 0; // block of the previous call, and its range of cells
};

} // namespace ciel
