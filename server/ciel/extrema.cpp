// Sorted local minima (paper, section 2.2), and maxima for sweeping downwards. The order (value, id) leaves no ties: a
// plateau has exactly the extrema that its rim needs.
#include "ciel/blocks.hpp"
#include "ciel/field_blocks.hpp"
#include "ciel/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace ciel {

namespace {

void mark(std::uint8_t& flag) { std::atomic_ref(flag).store(1, std::memory_order_relaxed); }

class RuleOut {
public:
    RuleOut(const Block& block, std::span<const float> values, std::vector<std::uint8_t>& not_minimum,
            std::vector<std::uint8_t>& not_maximum)
        : block_(block), values_(values), not_minimum_(not_minimum), not_maximum_(not_maximum) {}

    void run() {
        for (const StandardSection& section : block_.standard)
            with_shape(section.shape->type, [&]<const StandardShape & shape>() {
                for (std::size_t begin = 0; begin < section.vertex.size(); begin += shape.corners)
                    for (std::size_t e = 0; e < shape.edges; ++e)
                        edge(section.vertex[begin + shape.edge_ends[e][0]],
                             section.vertex[begin + shape.edge_ends[e][1]]);
            });
        block_.with([&](const auto& arrays) {
            const auto& polyhedra = arrays.polyhedra;
            for (Index face = 0; face < polyhedra.face_count(); ++face)
                for (Index k = polyhedra.face_begin[face]; k < polyhedra.face_begin[face + 1]; ++k)
                    edge(polyhedra.vertex[k], polyhedra.vertex[polyhedra.next_in_loop(k, face)]);
        });
    }

private:
    // An edge rules its upper end out as a minimum and its lower end as a maximum. The order of local ids is that of
    // the mesh's.
    void edge(Index a, Index b) {
        if (std::isnan(values_[a]) || std::isnan(values_[b])) return;
        const bool upward = values_[a] != values_[b] ? values_[a] < values_[b] : a < b;
        mark(not_minimum_[block_.vertex(upward ? b : a)]);
        mark(not_maximum_[block_.vertex(upward ? a : b)]);
    }

    const Block& block_;
    std::span<const float> values_;
    std::vector<std::uint8_t>&not_minimum_, &not_maximum_;
};

} // namespace

void Field::Blocks::make_extrema() const {
    const Locked lock(extrema_mutex);
    if (extrema_made) return;
    extrema_made = true;
    const Topology::Blocks& all = topology->blocks();
    std::vector<std::uint8_t> not_minimum(values.size(), 0), not_maximum(values.size(), 0);
    parallel_for(all.block.size(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b)
            RuleOut(all.block[b], of_block(static_cast<Index>(b)), not_minimum, not_maximum).run();
    });
    for (Index v = 0; v < values.size(); ++v) {
        if (!std::isfinite(values[v]) || topology->half_edge_of_vertex(v) == none) continue;
        if (!not_minimum[v]) minima.push_back(v);
        if (!not_maximum[v]) maxima.push_back(v);
    }
    const auto below = [this](Index a, Index b) { return values[a] != values[b] ? values[a] < values[b] : a < b; };
    std::ranges::sort(minima, below);
    std::ranges::sort(maxima, [&](Index a, Index b) { return below(b, a); });
}

} // namespace ciel
