// Counts the faces on which the points of a surface can be joined in more than one way (paper, section 4).
#include "blocks/blocks.hpp"
#include "blocks/cell_loops.hpp"
#include "ciel/field.hpp"
#include "ciel/parallel.hpp"
#include "mesh/loop.hpp"

#include <atomic>
#include <cmath>

namespace ciel {

using detail::append_without_repeats;
using detail::CellLoops;
using detail::for_cells;

namespace {

bool is_ambiguous(std::span<const Index> loop, ValuesView values) {
    const auto above = [&](Index a, Index b) { return values[a] != values[b] ? values[a] > values[b] : a > b; };
    int maxima = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index here = loop[i], before = loop[i == 0 ? loop.size() - 1 : i - 1],
                    after = loop[i + 1 == loop.size() ? 0 : i + 1];
        if (!std::isfinite(values[here])) return false;
        if (above(here, before) && above(here, after)) ++maxima;
    }
    return maxima > 1;
}

} // namespace

std::uint64_t count_ambiguous_faces(const Topology& topology, const FaceMeshView& boundary, ValuesView values) {
    if (values.size() != topology.counts().vertices)
        fail("counting ambiguous faces needs one value for each vertex; pass as many values as the topology has "
             "vertices");
    const Topology::Blocks& blocks = topology.blocks();
    // Every face is counted twice: inner faces from both cells, boundary faces here and in the loop over `boundary`.
    std::atomic<std::uint64_t> sides{0};
    parallel_for(blocks.count(), 4, [&](std::size_t begin, std::size_t end) {
        CellLoops loops;
        std::vector<Index> loop;
        std::uint64_t found = 0;
        for (auto b = static_cast<Index>(begin); b < end; ++b)
            for_cells(blocks.cells(b), loops, [&](Index, const CellLoops& of_cell) {
                for (std::size_t face = 0; face < of_cell.count(); ++face) {
                    loop.clear();
                    append_without_repeats(of_cell.face(face), loop);
                    found += is_ambiguous(loop, values) ? 1 : 0;
                }
            });
        sides += found;
    });
    std::vector<Index> loop;
    for (Index face = 0; face < boundary.face_count(); ++face) {
        if (boundary.neighbour[face] != none) continue;
        loop.clear();
        append_without_repeats(boundary.loop(face), loop);
        sides += is_ambiguous(loop, values) ? 1 : 0;
    }
    return sides / 2;
}

} // namespace ciel
