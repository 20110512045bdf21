// Fills the PolyhedralSection of a block. A face between two cells of the section is stored once.
#include "blocks/block_builder.hpp"
#include "blocks/pair_half_edges.hpp"

#include <algorithm>

namespace ciel::detail {

namespace {

template <class Local>
class Filler {
public:
    Filler(const BlockLoops& loops, std::span<const Index> cells, BuiltBlock& built)
        : loops_(loops), cells_(cells), built_(built),
          out_(std::get<PolyhedralSection<Local, Owned>>(built.block.polyhedra)),
          mates_(std::get<MateArrays<Local, Owned>>(built.mates.arrays)) {}

    void run(std::span<std::array<Index, 2>> anchor) {
        out_.half_edge_begin = built_.block.half_edge_count;
        out_.face_begin.assign(1, 0);
        out_.cell_face_begin.assign(1, 0);
        if (cells_.size() != built_.block.cell_count) out_.cell.assign(cells_.begin(), cells_.end());
        place_faces();
        list_cell_faces();
        built_.block.half_edge_count += static_cast<Index>(out_.vertex.size() + out_.inner_corners);
        set_anchors(anchor);
        pair();
        shrink();
    }

private:
    [[nodiscard]] Index section_cell(Index loop, Index side) const {
        const Index cell = loops_.cell_on(loop, side);
        return cell == none ? none : section_cell_[cell];
    }
    void place_faces();
    void append_face(Index loop);
    void list_cell_faces();
    void set_anchors(std::span<std::array<Index, 2>> anchor);
    void pair();
    void set_mate(Index h, Index mate, Index mate_face);
    void shrink();

    const BlockLoops& loops_;
    std::span<const Index> cells_;
    BuiltBlock& built_;
    PolyhedralSection<Local, Owned>& out_;
    MateArrays<Local, Owned>& mates_;
    std::vector<Index> section_cell_; // local cell -> its index in the section, or none
    std::vector<Index> face_of_;      // loop of the block -> face of the section, or none
    std::vector<Index> loop_of_;      // face of the section -> loop of the block
};

template <class Local>
void Filler<Local>::append_face(Index loop) {
    face_of_[loop] = static_cast<Index>(loop_of_.size());
    loop_of_.push_back(loop);
    for (Index k = loops_.begin[loop]; k < loops_.begin[loop + 1]; ++k) {
        out_.vertex.push_back(static_cast<Local>(loops_.vertex[k]));
        out_.edge.push_back(static_cast<Local>(loops_.edge[k]));
    }
    out_.face_begin.push_back(static_cast<Local>(out_.vertex.size()));
}

template <class Local>
void Filler<Local>::place_faces() {
    section_cell_.assign(built_.block.cell_count, none);
    for (Index i = 0; i < cells_.size(); ++i) section_cell_[cells_[i]] = i;
    face_of_.assign(loops_.loop_count(), none);
    const auto append = [&](bool with_owner, bool with_neighbour) {
        for (Index loop = 0; loop < loops_.loop_count(); ++loop)
            if (loops_.begin[loop] != loops_.begin[loop + 1] && (section_cell(loop, 0) != none) == with_owner &&
                (section_cell(loop, 1) != none) == with_neighbour)
                append_face(loop);
    };
    append(true, true);
    out_.inner_faces = static_cast<Index>(loop_of_.size());
    out_.inner_corners = static_cast<Index>(out_.vertex.size());
    append(true, false);
    out_.far_corner = static_cast<Index>(out_.vertex.size());
    append(false, true);
    out_.face_start.assign((out_.vertex.size() + 63) / 64, 0);
    for (std::size_t f = 0; f + 1 < out_.face_begin.size(); ++f)
        out_.face_start[out_.face_begin[f] / 64] |= std::uint64_t{1} << out_.face_begin[f] % 64;
    const Index part = built_.block.vertices_per_part();
    out_.corner_parts.assign(out_.face_start.size(), 0);
    for (std::size_t k = 0; k < out_.vertex.size(); ++k)
        out_.corner_parts[k / 64] |= std::uint64_t{1} << out_.vertex[k] / part;
    Index rank = 0;
    for (const std::uint64_t word : out_.face_start) {
        out_.face_rank.push_back(static_cast<Local>(rank));
        rank += static_cast<Index>(std::popcount(word));
    }
}

template <class Local>
void Filler<Local>::list_cell_faces() {
    out_.face_cell.resize(loop_of_.size());
    for (Index i = 0; i < cells_.size(); ++i) {
        for (const LoopRef ref : loops_.of_cell(cells_[i])) {
            const Index face = face_of_[ref / 2];
            out_.cell_face.push_back(static_cast<Local>(2 * face + ref % 2));
            if (face < out_.inner_faces)
                out_.face_cell[face][ref % 2] = static_cast<Local>(i);
            else
                out_.face_cell[face] = {static_cast<Local>(i), static_cast<Local>(i)};
        }
        out_.cell_face_begin.push_back(static_cast<Local>(out_.cell_face.size()));
    }
}

template <class Local>
void Filler<Local>::set_anchors(std::span<std::array<Index, 2>> anchor) {
    built_.mates.twin_begin = static_cast<Index>(built_.tails.size());
    for (Index face = 0; face < loop_of_.size(); ++face) {
        const Index loop = loop_of_[face], corner = out_.face_begin[face];
        const auto at = [&](Index side) { return out_.half_edge_begin + out_.half_edge(corner, side); };
        if (face < out_.inner_faces) {
            anchor[loop] = {at(0), at(1)};
            continue;
        }
        const Index side = corner >= out_.far_corner ? 1 : 0;
        anchor[loop][side] = at(side);
        built_.tails.push_back(
            {loops_.mesh_face[loop], side, loops_.mesh_cell[loop][1 - side], at(side), 0, anchor[loop][1 - side]});
    }
}

template <class Local>
void Filler<Local>::pair() {
    mates_.mate_face.resize((out_.vertex.size() + out_.inner_corners + 1) / 2);
    HalfEdgePairs pairs;
    Index left = out_.half_edge_count();
    for (Index cell = 0; cell < cells_.size(); ++cell)
        if (!pairs.run(out_, cell, left,
                       [this](Index h, Index mate, Index mate_face) { set_mate(h, mate, mate_face); }))
            fail("the mesh is damaged: cell " + std::to_string(loops_.cell_begin + cells_[cell]) +
                 " is not closed; import it again");
    std::ranges::sort(mates_.mate_escapes, {}, &MateEscape::half_edge);
}

template <class Local>
void Filler<Local>::set_mate(Index h, Index mate, Index mate_face) {
    const auto put = [&](Index bits) {
        std::uint8_t& byte = mates_.mate_face[h / 2];
        const Index shift = 4 * (h % 2);
        byte = static_cast<std::uint8_t>((byte & ~(15U << shift)) | bits << shift);
    };
    put(mate_face % mates_.escape);
    if (mates_.mate(out_, h) == mate) return;
    put(mates_.escape);
    mates_.mate_escapes.push_back({h, mate});
}

template <class Local>
void Filler<Local>::shrink() {
    const auto fit = [](auto&... vectors) { (vectors.shrink_to_fit(), ...); };
    fit(out_.vertex, out_.edge, mates_.mate_face, mates_.mate_escapes, out_.face_begin, out_.face_rank, out_.cell_face,
        out_.cell_face_begin);
}

} // namespace

template <class Local>
void fill_polyhedra(const BlockLoops& loops, std::span<const Index> cells, BuiltBlock& built,
                    std::span<std::array<Index, 2>> anchor) {
    built.block.polyhedra.emplace<PolyhedralSection<Local, Owned>>();
    built.mates.arrays.emplace<MateArrays<Local, Owned>>();
    if (!cells.empty()) Filler<Local>(loops, cells, built).run(anchor);
}

template void fill_polyhedra<std::uint16_t>(const BlockLoops&, std::span<const Index>, BuiltBlock&,
                                            std::span<std::array<Index, 2>>);
template void fill_polyhedra<std::uint32_t>(const BlockLoops&, std::span<const Index>, BuiltBlock&,
                                            std::span<std::array<Index, 2>>);

} // namespace ciel::detail
