#include "extraction/adopted_edges.hpp"

#include "parallel/grain.hpp"

#include <algorithm>

namespace ciel::detail {

namespace {

void list_edges(const Topology::Blocks& blocks, const Cutter& cutter, Index b, const ActiveBlock& cut,
                std::vector<AdoptedEdges::Edge>& out) {
    const Block& block = blocks.cells(b);
    const std::vector<Index>& begin = blocks.numbers.edge;
    Index owner_begin = 0, owner_edges = 0; // edges of the last owner found, which often owns the next edge too
    bool is_left_out = false;
    Index end = 0;
    for (std::size_t w = 0; end < cut.ghosts; ++w)
        for (std::uint64_t bits = cut.active[w]; bits != 0 && end < cut.ghosts; bits &= bits - 1, ++end) {
            const Index edge = block.ghost_edge[64 * w + static_cast<std::size_t>(std::countr_zero(bits))];
            if (edge - owner_begin >= owner_edges) {
                const auto owner = std::ranges::upper_bound(begin, edge) - begin.begin() - 1;
                is_left_out = !cutter.has(static_cast<Index>(owner));
                owner_begin = begin[static_cast<std::size_t>(owner)];
                owner_edges = begin[static_cast<std::size_t>(owner) + 1] - owner_begin;
            }
            if (!is_left_out) continue;
            if (edge >= begin[b]) refuse_changed("a block refers to an edge that no earlier block owns");
            out.push_back({edge, b, end, none});
        }
}

} // namespace

void AdoptedEdges::find(const Topology::Blocks& blocks, Cutter& cutter) {
    edges_.clear();
    numbered_ = 0;
    const std::span<const Index> active = cutter.active();
    BlockCuts& cut = cutter.cut();
    for (const Index b : active) cut[b].adopted.clear();
    if (cutter.has_all()) return;
    if (found_.size() < active.size()) found_.resize(active.size());
    parallel_for(active.size(), fair_grain(active.size(), 4), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            found_[i].clear();
            list_edges(blocks, cutter, active[i], cut[active[i]], found_[i]);
        }
    });
    for (std::size_t i = 0; i < active.size(); ++i) edges_.insert(edges_.end(), found_[i].begin(), found_[i].end());
    std::ranges::sort(edges_, {}, [](const Edge& at) { return std::pair(at.edge, at.block); });
    const auto same = [](const Edge& a, const Edge& b) { return a.edge == b.edge; };
    edges_.erase(std::unique(edges_.begin(), edges_.end(), same), edges_.end());
    for (const Edge& edge : edges_) cut[edge.block].adopted.push_back(edge.end);
}

std::uint64_t AdoptedEdges::number_below(Index edge, std::uint64_t next) {
    for (; numbered_ < edges_.size() && edges_[numbered_].edge < edge; ++numbered_)
        edges_[numbered_].point = static_cast<Index>(next++);
    return next;
}

Index AdoptedEdges::point_of(Index edge) const {
    const auto at = std::ranges::lower_bound(edges_, edge, {}, &Edge::edge);
    if (at == edges_.end() || at->edge != edge)
        refuse_changed("an edge that a left-out block owns has another id than before");
    return at->point;
}

std::size_t AdoptedEdges::memory_bytes() const {
    std::size_t count = edges_.capacity();
    for (const std::vector<Edge>& found : found_) count += found.capacity();
    return count * sizeof(Edge) + found_.capacity() * sizeof(std::vector<Edge>);
}

} // namespace ciel::detail
