// The mates of a block's half-edges, for the operators mate_face and mate_polyhedron (paper, section 2.2). Surfaces and
// pictures do without them; propagation needs them.
#pragma once

#include "blocks/block.hpp"

#include <limits>

namespace ciel {

// A HalfEdge is the number of its block, then its local number in the block.
[[nodiscard]] inline HalfEdge half_edge_in(Index block, Index local) {
    return static_cast<HalfEdge>(std::uint64_t{block} << 32 | local);
}
[[nodiscard]] inline Index block_of(HalfEdge h) { return static_cast<Index>(static_cast<std::uint64_t>(h) >> 32); }
[[nodiscard]] inline Index local_of(HalfEdge h) { return static_cast<Index>(h); }

// Stored instead of a mate for faces on the boundary, which have none.
inline constexpr std::uint16_t no_mate = std::numeric_limits<std::uint16_t>::max();

struct MateEscape {
    Index half_edge, mate; // within the PolyhedralSection; they may exceed 16 bits
};

template <class Local, template <class> class Array = Viewed>
struct MateArrays {
    static constexpr Index escape = 15, longest_search = 256;
    static constexpr Local no_block = std::numeric_limits<Local>::max();

    // Four bits per half-edge of the PolyhedralSection: index of the face with its mate, among the faces of the cell,
    // modulo `escape`. The value `escape` means that the mate is in mate_escapes. It is used where `mate` would search
    // more than longest_search corners or find another half-edge.
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
    std::vector<Index> neighbour; // blocks of the twins, ascending; the block itself for a twin in another section
    Array<Index> twin_half_edge;  // mates that are in other blocks or sections: local numbers there
    Index twin_begin = 0;         // twin of the first tail face of the PolyhedralSection
    // By standard section, cell and face: the mate of the first half-edge of the face. If the mate is in a standard
    // section of the block: its local half-edge. Otherwise Block::standard_half_edges + a twin, or no_mate on the
    // boundary.
    std::vector<Array<std::uint16_t>> mate;
    std::variant<MateArrays<std::uint16_t, Array>, MateArrays<std::uint32_t, Array>> arrays;
    RecordBytes copied; // as in BlockOf

    // Returns no_half_edge on the boundary. If the record has changed, the half-edge may not exist, but its block does.
    [[nodiscard]] HalfEdge twin(Index i) const;
};
using BlockMates = BlockMatesOf<Viewed>;

// Calls f(PolyhedralSection, MateArrays) with those of a block. The ids of both have the same size.
template <class F>
decltype(auto) with_mates(const Block& block, const BlockMates& mates, F&& f) {
    return block.with([&]<class Local>(const PolyhedralSection<Local>& polyhedra) -> decltype(auto) {
        return f(polyhedra, std::get<MateArrays<Local>>(mates.arrays));
    });
}

} // namespace ciel
