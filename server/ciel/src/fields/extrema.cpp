// Finds the sorted local minima (paper, section 2.2), and the maxima for sweeping downwards. Vertices are compared by
// (value, id). This order has no ties, so a plateau has extrema, too.
#include "blocks/blocks.hpp"
#include "ciel/geometric_vertices.hpp"
#include "ciel/parallel.hpp"
#include "fields/field_data.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace ciel {

using namespace detail;

namespace {

void mark(std::uint8_t& flag) { std::atomic_ref(flag).store(1, std::memory_order_relaxed); }

class RuleOut {
public:
    RuleOut(const Block& block, ValuesView values, std::vector<std::uint8_t>& not_minimum,
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
        block_.with([&](const auto& polyhedra) {
            polyhedra.for_corners([&](Index face, Index k) {
                edge(polyhedra.vertex[k], polyhedra.vertex[polyhedra.next_in_loop(k, face)]);
            });
        });
    }

private:
    // Local ids can be compared, because they have the same order as mesh ids.
    void edge(Index a, Index b) {
        if (std::isnan(values_[a]) || std::isnan(values_[b])) return;
        const bool upward = values_[a] != values_[b] ? values_[a] < values_[b] : a < b;
        mark(not_minimum_[block_.vertex(upward ? b : a)]);
        mark(not_maximum_[block_.vertex(upward ? a : b)]);
    }

    const Block& block_;
    ValuesView values_;
    std::vector<std::uint8_t>&not_minimum_, &not_maximum_;
};

// Removes vertices without a finite value, and sorts the others. Calls value(vertex) only once per vertex: if a mapped
// value changed during the sort, std::sort could read out of bounds.
template <class Value>
void sort_by_value(std::vector<Index>& vertices, const Value& value) {
    std::vector<std::pair<double, Index>> all;
    all.reserve(vertices.size());
    for (const Index v : vertices)
        if (const double of = value(v); std::isfinite(of)) all.emplace_back(of, v);
    std::ranges::sort(all);
    vertices.clear();
    for (const auto& [of, v] : all) vertices.push_back(v);
}

} // namespace

void Field::Data::find_extrema() const {
    const Topology::Blocks& all = topology->blocks();
    std::vector<std::uint8_t> not_minimum(topology->counts().vertices, 0), not_maximum(not_minimum);
    parallel_for(all.count(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b)
            RuleOut(all.cells(static_cast<Index>(b)), of_block(static_cast<Index>(b)), not_minimum, not_maximum).run();
    });
    for (Index v = 0; v < not_minimum.size(); ++v) {
        if (!std::isfinite(value(v)) || topology->half_edge_of_vertex(v) == no_half_edge) continue;
        if (!not_minimum[v]) minima.push_back(v);
        if (!not_maximum[v]) maxima.push_back(v);
    }
}

// Searches boundary vertices and reflex corners only. Returns false if the values are no plane distances, or so large
// that two distances may round to the same float, because any vertex may then be an extremum.
bool Field::Data::find_geometric_extrema() const {
    if (!where_extrema) return false;
    const GeometricVertices::Found& where = where_extrema->find(*topology);
    const double largest = std::max(std::abs(range[0]), std::abs(range[1]));
    if (!(largest <= direction_length * where.largest_distance)) return false;
    std::vector<std::uint8_t> sides(where.vertices.size(), 0); // flags: 1: a neighbor is lower, 2: a neighbor is higher
    parallel_for(sides.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Index v = where.vertices[i];
            const HalfEdge start = topology->half_edge_of_vertex(v);
            if (start == no_half_edge || !std::isfinite(value(v))) sides[i] = 3;
            WalkEnds walk(topology->counts());
            for (HalfEdge h = start; sides[i] != 3; walk.step(h)) {
                const Index other = topology->vertex(h);
                if (const double there = value(other); std::isfinite(there))
                    sides[i] |= std::pair(there, other) < std::pair(value(v), v) ? 1 : 2;
                h = topology->next_around_vertex(h);
                if (h == start) break;
            }
        }
    });
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if ((sides[i] & 1) == 0) minima.push_back(where.vertices[i]);
        if ((sides[i] & 2) == 0) maxima.push_back(where.vertices[i]);
    }
    return true;
}

void Field::Data::make_extrema() const {
    const Locked lock(extrema_mutex);
    if (extrema_made) return;
    read_all();
    minima.clear();
    maxima.clear();
    if (!find_geometric_extrema()) find_extrema();
    const auto value_of = [this](Index vertex) { return value(vertex); };
    sort_by_value(minima, value_of);
    sort_by_value(maxima, value_of);
    std::ranges::reverse(maxima);
    extrema_made = true;
}

} // namespace ciel
