// What leads around a vertex: the entries of each vertex in a block, and the other blocks that have it. For gradients,
// and for next_around_vertex (paper, section 2.2 and appendix A).
#pragma once

#include "blocks/block.hpp"

#include <limits>

namespace ciel {

template <class Local, template <class> class Array = Viewed>
struct AroundArrays {
    static constexpr Local end_of_list = std::numeric_limits<Local>::max();

    Array<Local> first_entry; // by local vertex: its first entry, or end_of_list
    Array<Local> next_entry;  // by corner of the PolyhedralSection: next entry of the vertex, or end_of_list
    // border_vertex: local vertices that other blocks have too, ascending. The blocks of such a vertex form a ring:
    // each leads to the next higher block, the last to the first. border_block: the next block in the ring, as an index
    // into BlockAroundOf::neighbour. border_place: index of the vertex in border_vertex of that block.
    Array<Local> border_vertex, border_block, border_place;
};

template <template <class> class Array>
struct BlockAroundOf {
    std::vector<Index> neighbour;                 // blocks that come next in a ring, ascending
    std::vector<Array<std::uint16_t>> next_entry; // by standard section and corner, as in AroundArrays
    std::variant<AroundArrays<std::uint16_t, Array>, AroundArrays<std::uint32_t, Array>> arrays;
    RecordBytes copied; // as in BlockOf

    // Returns the index of the vertex in border_vertex, or none if no other block has the vertex.
    [[nodiscard]] Index border_place_of(Index local_vertex) const {
        return with([&](const auto& all) {
            const auto found = std::ranges::lower_bound(all.border_vertex, local_vertex);
            return found != all.border_vertex.end() && *found == local_vertex
                       ? static_cast<Index>(found - all.border_vertex.begin())
                       : none;
        });
    }
    template <class F>
    decltype(auto) with(F&& f) const {
        return std::visit(std::forward<F>(f), arrays);
    }
};
using BlockAround = BlockAroundOf<Viewed>;

// Calls f(PolyhedralSection, AroundArrays) with those of a block. The ids of both have the same size.
template <class F>
decltype(auto) with_around(const Block& block, const BlockAround& around, F&& f) {
    return block.with([&]<class Local>(const PolyhedralSection<Local>& polyhedra) -> decltype(auto) {
        return f(polyhedra, std::get<AroundArrays<Local>>(around.arrays));
    });
}

// Returns the entry after `entry` in `list`, the next_entry of a section whose entries start at `begin`. Throws Error
// if it is not above `entry`: a changed list might otherwise have no end.
template <class Local>
[[nodiscard]] Index next_entry(std::span<const Local> list, Index entry, Index begin) {
    const Index next = read_once(list[entry - begin]);
    if (next <= entry) [[unlikely]]
        refuse_changed("a list of entries does not ascend");
    return next;
}

// Returns the first entry of the vertex that is at least `begin`, or end_of_list, which is above all entries.
[[nodiscard]] Index first_entry_from(const Block& block, const BlockAround& around, Index local_vertex, Index begin);

} // namespace ciel
