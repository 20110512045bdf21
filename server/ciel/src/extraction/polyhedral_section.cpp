// Fills the PolyhedralSection of a block. A face between two of its cells is stored once for both.
#include "blocks/block_builder.hpp"

#include <algorithm>

namespace ciel {

namespace {

template <class Local>
class Filler {
public:
    Filler(const BlockLoops& loops, std::span<const Index> cells, BuiltBlock& built, PolyhedralSection<Local>& out)
        : loops_(loops), cells_(cells), built_(built), out_(out) {}

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
    void pair_half_edge(Index h, Index face_of_cell);
    void pair_inside_faces(Index cell);
    void set_mate(Index h, Index mate, Index mate_face);
    [[nodiscard]] bool runs_upward(Index h) const;
    void shrink();

    const BlockLoops& loops_;
    std::span<const Index> cells_;
    BuiltBlock& built_;
    PolyhedralSection<Local>& out_;
    std::vector<Index> section_cell_; // local cell -> its index in the section, or none
    std::vector<Index> face_of_;      // loop of the block -> face of the section, or none
    std::vector<Index> loop_of_;      // face of the section -> loop of the block
    struct Waiting {
        Index half_edge, face_of_cell, next;
    };
    std::vector<Index> open_; // local edge -> list of the current cell's unpaired half-edges, in waiting_
    std::vector<Waiting> waiting_;
    std::vector<Index> touched_; // local edges of the current cell
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

// Stores the faces in three groups: faces between two cells of the section, faces with only their owner in the section,
// faces with only their neighbor in the section.
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
    out_.twin_begin = static_cast<Index>(built_.tails.size());
    for (Index face = 0; face < loop_of_.size(); ++face) {
        const Index loop = loop_of_[face], corner = out_.face_begin[face];
        const auto at = [&](Index side) { return out_.half_edge_begin + out_.half_edge(corner, side); };
        if (face < out_.inner_faces) {
            anchor[loop] = {at(0), at(1)};
            continue;
        }
        const Index side = corner >= out_.far_corner ? 1 : 0;
        anchor[loop][side] = at(side);
        built_.tails.push_back({loops_.mesh_face[loop], side, at(side), 0, anchor[loop][1 - side]});
    }
}

template <class Local>
bool Filler<Local>::runs_upward(Index h) const {
    const Index corner = out_.corner(h);
    return (out_.vertex[corner] == loops_.edge_ends[out_.edge[corner]][0]) == (out_.side(h) == 0);
}

// Pairs the two half-edges of each edge in each cell. If a cell touches itself along an edge, the edge has more than
// two half-edges in the cell. Then any pairing of opposite directions is valid, and pairs in different faces are
// preferred.
template <class Local>
void Filler<Local>::pair() {
    out_.mate_face.resize((out_.vertex.size() + out_.inner_corners + 1) / 2);
    open_.assign(loops_.edge_ends.size(), none);
    for (Index cell = 0; cell < cells_.size(); ++cell) {
        waiting_.clear();
        touched_.clear();
        const auto faces = out_.faces_of(cell);
        for (Index i = 0; i < faces.size(); ++i)
            for (Index k = out_.face_begin[faces[i] / 2]; k < out_.face_begin[faces[i] / 2 + 1]; ++k)
                pair_half_edge(out_.half_edge(k, faces[i] % 2), i);
        pair_inside_faces(cell);
    }
    std::ranges::sort(out_.mate_escapes);
}

template <class Local>
void Filler<Local>::pair_half_edge(Index h, Index face_of_cell) {
    const Index edge = out_.edge[out_.corner(h)];
    const bool upward = runs_upward(h);
    Index* link = &open_[edge];
    if (*link == none) touched_.push_back(edge);
    while (*link != none &&
           (runs_upward(waiting_[*link].half_edge) == upward || waiting_[*link].face_of_cell == face_of_cell))
        link = &waiting_[*link].next;
    if (*link == none) {
        waiting_.push_back({h, face_of_cell, open_[edge]});
        open_[edge] = static_cast<Index>(waiting_.size() - 1);
        return;
    }
    const Waiting mate = waiting_[*link];
    *link = mate.next;
    set_mate(h, mate.half_edge, mate.face_of_cell);
    set_mate(mate.half_edge, h, face_of_cell);
}

// Pairs the half-edges of the cell that pair_half_edge left unpaired. In a face that collapsed to a line, both
// half-edges of a pair may be in that face.
template <class Local>
void Filler<Local>::pair_inside_faces(Index cell) {
    for (const Index edge : touched_) {
        while (open_[edge] != none) {
            const Waiting waiting = waiting_[open_[edge]];
            Index* link = &waiting_[open_[edge]].next;
            while (*link != none && runs_upward(waiting_[*link].half_edge) == runs_upward(waiting.half_edge))
                link = &waiting_[*link].next;
            if (*link == none)
                fail("the mesh is damaged: cell " + std::to_string(loops_.cell_begin + cells_[cell]) +
                     " is not closed; import it again");
            const Waiting mate = waiting_[*link];
            *link = mate.next;
            open_[edge] = waiting_[open_[edge]].next;
            set_mate(waiting.half_edge, mate.half_edge, mate.face_of_cell);
            set_mate(mate.half_edge, waiting.half_edge, waiting.face_of_cell);
        }
    }
}

// Stores the mate of half-edge h. `mate_face`: index of the face of the mate among the faces of the cell. Uses four
// bits of mate_face when PolyhedralSection::mate finds the mate with them, else an entry of mate_escapes.
template <class Local>
void Filler<Local>::set_mate(Index h, Index mate, Index mate_face) {
    const auto put = [&](Index bits) {
        std::uint8_t& byte = out_.mate_face[h / 2];
        const Index shift = 4 * (h % 2);
        byte = static_cast<std::uint8_t>((byte & ~(15U << shift)) | bits << shift);
    };
    put(mate_face % out_.escape);
    if (out_.mate(h) == mate) return;
    put(out_.escape);
    out_.mate_escapes.emplace_back(h, mate);
}

template <class Local>
void Filler<Local>::shrink() {
    const auto fit = [](auto&... vectors) { (vectors.shrink_to_fit(), ...); };
    fit(out_.vertex, out_.edge, out_.mate_face, out_.mate_escapes, out_.face_begin, out_.face_rank, out_.cell_face,
        out_.cell_face_begin);
}

} // namespace

template <class Local>
void fill_polyhedra(const BlockLoops& loops, std::span<const Index> cells, BuiltBlock& built,
                    PolyhedralSection<Local>& out, std::span<std::array<Index, 2>> anchor) {
    if (!cells.empty()) Filler<Local>(loops, cells, built, out).run(anchor);
}

template void fill_polyhedra(const BlockLoops&, std::span<const Index>, BuiltBlock&, PolyhedralSection<std::uint16_t>&,
                             std::span<std::array<Index, 2>>);
template void fill_polyhedra(const BlockLoops&, std::span<const Index>, BuiltBlock&, PolyhedralSection<std::uint32_t>&,
                             std::span<std::array<Index, 2>>);

} // namespace ciel
