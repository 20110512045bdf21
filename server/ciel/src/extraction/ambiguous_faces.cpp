// Counts the faces on which the points of a surface can be joined in more than one way (paper, section 4).
#include "blocks/blocks.hpp"
#include "blocks/cell_loops.hpp"
#include "ciel/field.hpp"
#include "ciel/parallel.hpp"
#include "mesh/loop.hpp"

#include <atomic>
#include <cmath>

namespace ciel {

using namespace detail;

namespace {

// Values: a span or ValuesView.
template <class Values>
bool is_ambiguous(std::span<const Index> loop, const Values& values) {
    if (loop.size() < 4) return false; // two maxima are not neighbors of each other
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

// Return the number of ambiguous faces; a face between two cells of a PolyhedralSection counts twice.
template <class Values>
std::uint64_t count_in(const Block& block, const StandardSection& section, const Values& values) {
    const StandardShape& shape = *section.shape;
    if (shape.type == CellType::tetrahedron) return 0;
    std::uint64_t found = 0;
    for (Index i = 0; i < section.count(); ++i)
        for (std::size_t face = 0; face < shape.faces; ++face) {
            if (shape.face_size(face) != 4) continue;
            std::array<Index, 4> loop;
            for (std::size_t c = 0; c < loop.size(); ++c) {
                const std::size_t corner = shape.origin[shape.face_begin[face] + c];
                loop[c] = block.vertex(read_once(section.vertex[i * shape.corners + corner]));
            }
            found += is_ambiguous(loop, values) ? 1 : 0;
        }
    return found;
}

template <class Local, template <class> class Array, class Values>
std::uint64_t count_in(const Block& block, const PolyhedralSection<Local, Array>& section, const Values& values) {
    std::vector<Index> loop;
    std::uint64_t found = 0;
    for (Index face = 0, corner = 0; face < section.face_count(); ++face) {
        loop.clear();
        for (const Index end = corners_of_face(section, face).end; corner < end; ++corner)
            loop.push_back(block.vertex(read_once(section.vertex[corner])));
        if (is_ambiguous(loop, values)) found += face < section.inner_faces ? 2 : 1;
    }
    return found;
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
        for (auto b = static_cast<Index>(begin); b < end; ++b)
            values.with([&](const auto& typed) {
                const Block& block = blocks.cells(b);
                for (const StandardSection& section : block.standard) sides += count_in(block, section, typed);
                block.with([&](const auto& section) { sides += count_in(block, section, typed); });
            });
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
