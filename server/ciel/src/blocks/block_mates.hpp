// The mates of a block's half-edges (paper, section 2.2), for the operators of Topology and for propagation.
#pragma once

#include "blocks/block.hpp"

#include <limits>

namespace ciel::detail {

// The upper 32 bits of a HalfEdge are the number of its block. The lower 32 bits are its local number in the block.
[[nodiscard]] inline HalfEdge half_edge_in(Index block, Index local) {
    return static_cast<HalfEdge>(std::uint64_t{block} << 32 | local);
}
[[nodiscard]] inline Index block_of(HalfEdge h) { return static_cast<Index>(static_cast<std::uint64_t>(h) >> 32); }
[[nodiscard]] inline Index local_of(HalfEdge h) { return static_cast<Index>(h); }

// Stored in BlockMatesOf::mate for a face on the boundary.
inline constexpr std::uint16_t no_mate = std::numeric_limits<std::uint16_t>::max();

struct MateEscape {
    Index half_edge, mate; // numbers in the PolyhedralSection, which may exceed 16 bits
};

template <class Local, template <class> class Array = Viewed>
struct MateArrays {
    static constexpr Index escape = 15, longest_search = 256;
    static constexpr Local no_block = std::numeric_limits<Local>::max();

    // Four bits per half-edge of the PolyhedralSection: the index, among the faces of the cell, of the face with the
    // mate, modulo `escape`. The value `escape` means that the mate is in mate_escapes, because the search in `mate`
    // would not find it.
    Array<std::uint8_t> mate_face;
    Array<MateEscape> mate_escapes; // sorted by half_edge
    // By twin: its block as an index into BlockMatesOf::neighbour; no_block on the boundary.
    Array<Local> twin_block;

    [[nodiscard]] Index mate_bits(Index half_edge) const {
        return Index{mate_face[half_edge / 2]} >> 4 * (half_edge % 2) & 15U;
    }
    // Returns the half-edge of the same edge in the adjacent face of the cell. In a face that collapsed to a line, the
    // mate may be in the face itself. The argument and the result are numbered within the section. If the record has
    // changed, may return none or a half-edge that does not exist.
    [[nodiscard]] Index mate(const PolyhedralSection<Local, Array>& polyhedra, Index half_edge) const;
};

template <template <class> class Array>
struct BlockMatesOf {
    std::vector<Index> neighbour; // blocks of the twins, ascending; includes this block if a twin is in it
    Array<Index> twin_half_edge;  // by twin (mate in another block or section): local number in its block
    Index twin_begin = 0;         // index of the twin of the first tail face of the PolyhedralSection
    // By standard section, cell and face: the mate of the first half-edge of the face. If the mate is in a standard
    // section of the block, the entry is its local half-edge. Otherwise the entry is Block::standard_half_edges + the
    // index of the twin, or no_mate on the boundary.
    std::vector<Array<std::uint16_t>> mate;
    std::variant<MateArrays<std::uint16_t, Array>, MateArrays<std::uint32_t, Array>> arrays;
    RecordBytes copied; // like BlockOf::copied

    // Returns the half-edge of twin i, or no_half_edge on the boundary. If the record has changed, the half-edge may
    // not exist, but its block exists.
    [[nodiscard]] HalfEdge twin(Index i) const;
};
using BlockMates = BlockMatesOf<Viewed>;

template <class F>
decltype(auto) with_mates(const Block& block, const BlockMates& mates, F&& f) {
    return block.with([&]<class Local>(const PolyhedralSection<Local>& polyhedra) -> decltype(auto) {
        return f(polyhedra, std::get<MateArrays<Local>>(mates.arrays));
    });
}

} // namespace ciel::detail
