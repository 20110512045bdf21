#include "blocks/block_loops.hpp"

#include "mesh/loop.hpp"

#include <algorithm>
#include <utility>

namespace ciel::detail {

void BlockLoops::gather(Index from, Index to) {
    cell_begin = from;
    cell_end = to;
    source_.list(from, to, *this);
    collapsed_.clear();
    if (has_repeats()) remove_repeats();
    check_sides();
    number_vertices();
    find_edges();
}

// Returns whether a loop repeats a vertex or is empty. remove_repeats must remove empty loops from the lists of cells.
bool BlockLoops::has_repeats() const {
    for (Index loop = 0; loop < loop_count(); ++loop) {
        const Index end = begin[loop + 1];
        if (begin[loop] == end) return true;
        Index last = vertex[end - 1];
        for (Index k = begin[loop]; k < end; ++k) {
            if (vertex[k] == last) return true;
            last = vertex[k];
        }
    }
    return false;
}

void BlockLoops::remove_repeats() {
    const std::vector<Index> whole = std::exchange(vertex, {}), whole_begin = std::exchange(begin, {0});
    for (std::size_t loop = 0; loop + 1 < whole_begin.size(); ++loop) {
        const auto ids = std::span(whole).subspan(whole_begin[loop], whole_begin[loop + 1] - whole_begin[loop]);
        const bool any = append_without_repeats(ids, vertex) > 0;
        if (!any && !ids.empty()) collapsed_.push_back(ids.front());
        begin.push_back(static_cast<Index>(vertex.size()));
    }
    const std::vector<Index> listed = std::exchange(cell_loop, {}), listed_begin = std::exchange(cell_loop_begin, {0});
    for (std::size_t cell = 0; cell + 1 < listed_begin.size(); ++cell) {
        for (Index i = listed_begin[cell]; i < listed_begin[cell + 1]; ++i)
            if (size(listed[i]) > 0) cell_loop.push_back(listed[i]);
        cell_loop_begin.push_back(static_cast<Index>(cell_loop.size()));
    }
}

// Throws Error when a loop has a cell of this block on one side, but the list of this cell does not have the loop.
void BlockLoops::check_sides() const {
    std::size_t sides = 0;
    for (Index loop = 0; loop < loop_count(); ++loop)
        if (begin[loop] != begin[loop + 1])
            sides += (cell_on(loop, 0) != none ? 1 : 0) + (cell_on(loop, 1) != none ? 1 : 0);
    if (sides != cell_loop.size()) source_.refuse();
}

void BlockLoops::number_vertices() {
    Index highest = 0;
    for (const auto* ids : {&vertex, &collapsed_})
        for (const Index v : *ids) highest = std::max(highest, v);
    if (highest >= source_.vertex_count()) source_.refuse();
    local_vertex_.begin(highest, vertex.size() + collapsed_.size());
    for (const auto* ids : {&vertex, &collapsed_})
        for (const Index v : *ids) local_vertex_.add(v);
    local_vertex_.number(vertices);
    for (Index& v : vertex) v = local_vertex_[v];
}

// Numbers the edges by first appearance, so that their mesh-wide order does not depend on the block size.
void BlockLoops::find_edges() {
    edge.resize(vertex.size());
    edge_ends.clear();
    edge_head_.assign(vertices.size(), none);
    edge_next_.clear();
    crowded_edge_.clear();
    for (Index loop = 0; loop < loop_count(); ++loop)
        for (Index k = begin[loop]; k < begin[loop + 1]; ++k) {
            const Index a = vertex[k], b = vertex[k + 1 == begin[loop + 1] ? begin[loop] : k + 1];
            edge[k] = edge_between(std::min(a, b), std::max(a, b));
        }
}

Index BlockLoops::edge_between(Index low, Index high) {
    constexpr Index most_listed = 64;
    Index listed = 0;
    for (Index e = edge_head_[low]; e != none; e = edge_next_[e], ++listed)
        if (edge_ends[e][1] == high) return e;
    const auto created = static_cast<Index>(edge_ends.size());
    if (listed == most_listed) {
        const auto [known, is_new] = crowded_edge_.try_emplace(std::uint64_t{low} << 32 | high, created);
        if (!is_new) return known->second;
    }
    edge_ends.push_back({low, high});
    edge_next_.push_back(listed < most_listed ? edge_head_[low] : none);
    if (listed < most_listed) edge_head_[low] = created;
    return created;
}

} // namespace ciel::detail
