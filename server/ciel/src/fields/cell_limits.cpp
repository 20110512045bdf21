#include "ciel/cell_limits.hpp"

#include "blocks/blocks.hpp"
#include "blocks/cell_loops.hpp"

#include <algorithm>
#include <cmath>

namespace ciel {

using namespace detail;

std::array<float, 2> CellLimits::of(Index cell, std::span<const float> values) {
    const Topology::Blocks& blocks = topology_.blocks();
    if (values.size() != topology_.counts().vertices)
        fail("cell limits need one value for each vertex of the mesh; pass as many values as the mesh has vertices");
    if (cell < cell_begin_ || cell >= cell_end_) {
        if (cell >= topology_.counts().cells) fail("the mesh has no such cell; pass a cell of the topology's mesh");
        block_ = blocks.block_of_cell(cell);
        cell_begin_ = blocks.numbers.cell[block_];
        cell_end_ = blocks.numbers.cell[block_ + 1];
    }
    float low = no_limits[0], high = no_limits[1];
    bool is_finite = true;
    for_corners_of_cell(blocks.cells(block_), cell - cell_begin_, [&](Index vertex) {
        const float value = values[vertex];
        is_finite = is_finite && std::isfinite(value);
        low = std::min(low, value);
        high = std::max(high, value);
    });
    return is_finite ? std::array{low, high} : no_limits;
}

} // namespace ciel
