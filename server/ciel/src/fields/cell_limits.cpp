#include "ciel/cell_limits.hpp"

#include "blocks/blocks.hpp"
#include "blocks/cell_loops.hpp"
#include "parallel/grain.hpp"

#include <algorithm>
#include <cmath>

namespace ciel {

using namespace detail;

std::vector<std::array<float, 2>> cell_limits(const Topology& topology, std::span<const float> values) {
    if (values.size() != topology.counts().vertices)
        fail("cell limits need one value for each vertex of the mesh; pass as many values as the mesh has vertices");
    const Topology::Blocks& blocks = topology.blocks();
    std::vector<std::array<float, 2>> limits(topology.counts().cells, no_limits);
    parallel_for(blocks.count(), fair_grain(blocks.count(), 16), [&](std::size_t begin, std::size_t end) {
        CellLoops loops;
        for (std::size_t b = begin; b < end; ++b)
            for_cells(blocks.cells(static_cast<Index>(b)), loops, [&](Index cell, const CellLoops& of_cell) {
                std::array<float, 2> range = no_limits;
                for (const Index vertex : of_cell.vertex) {
                    const float value = values[vertex];
                    if (!std::isfinite(value)) return;
                    range = {std::min(range[0], value), std::max(range[1], value)};
                }
                limits[cell] = range;
            });
    });
    return limits;
}

} // namespace ciel
