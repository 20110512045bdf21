// The links around each vertex of a block, for gradients and next_around_vertex (paper, section 2.2 and appendix A).
#pragma once

#include "blocks/block.hpp"

#include <limits>

namespace ciel::detail {

template <class Local, template <class> class Array = Viewed>
struct AroundArrays {
    static constexpr Local end_of_list = std::numeric_limits<Local>::max();

    Array<Local> first_entry; // by local vertex: its first entry, or end_of_list
    Array<Local> next_entry;  // by corner of the PolyhedralSection: next entry of the vertex, or end_of_list
    // border_vertex: the local vertices that other blocks also have, ascending. The blocks that have such a vertex form
    // a ring in ascending order; after the last block comes the first. border_block: the next block in the ring, as an
    // index into BlockAroundOf::neighbour. border_place: the index of the vertex in border_vertex of this next block.
    Array<Local> border_vertex, border_block, border_place;
};

template <template <class> class Array>
struct BlockAroundOf {
    std::vector<Index> neighbour;                 // all blocks that border_block refers to, ascending
    std::vector<Array<std::uint16_t>> next_entry; // by standard section: like AroundArrays::next_entry
    std::variant<AroundArrays<std::uint16_t, Array>, AroundArrays<std::uint32_t, Array>> arrays;
    RecordBytes copied; // like BlockOf::copied

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

template <class F>
decltype(auto) with_around(const Block& block, const BlockAround& around, F&& f) {
    return block.with([&]<class Local>(const PolyhedralSection<Local>& polyhedra) -> decltype(auto) {
        return f(polyhedra, std::get<AroundArrays<Local>>(around.arrays));
    });
}

// Returns the next entry of the same vertex after `entry`, or end_of_list. `list`: next_entry of the section with
// `entry`. `begin`: first entry of this section. Throws Error if the next entry is not greater than `entry`, because a
// walk along a changed list might otherwise never end.
template <class Local>
[[nodiscard]] Index next_entry(std::span<const Local> list, Index entry, Index begin) {
    const Index next = read_once(list[entry - begin]);
    if (next <= entry) [[unlikely]]
        refuse_changed("a list of entries does not ascend");
    return next;
}

// Returns the first entry of the vertex that is not below `begin`, the first entry of a section. Returns end_of_list,
// which is greater than all entries, if there is none.
[[nodiscard]] Index first_entry_from(const Block& block, const BlockAround& around, Index local_vertex, Index begin);

} // namespace ciel::detail
