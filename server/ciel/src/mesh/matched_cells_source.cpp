#include "mesh/matched_cells_source.hpp"

#include "mesh/loop.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace ciel::detail {

namespace {

using OwnFace = MatchedCells::Data::OwnFace;

class Listing {
public:
    Listing(const MatchedCells::Data& cells, Index cell_begin, Index cell_end, FaceLoops& out)
        : cells_(cells), begin_(cell_begin), end_(cell_end), first_face_(cells.own_begin[cell_begin]), out_(out) {}

    void run() {
        list_own();
        out_.cell_loop_begin.assign(1, 0);
        out_.cell_loop.clear();
        for (Index cell = begin_; cell < end_; ++cell) {
            list_others(cell);
            for (Index face = cells_.own_begin[cell]; face < cells_.own_begin[cell + 1]; ++face)
                out_.cell_loop.push_back(2 * (face - first_face_));
            out_.cell_loop_begin.push_back(static_cast<Index>(out_.cell_loop.size()));
        }
    }

private:
    static constexpr Index not_listed = none;
    struct Other {
        Index face;            // mesh face
        Index loop;            // in out_, or not_listed
        Index owner, of_owner; // of_owner: input face of the owner; none if the face is listed
    };

    void list_own() {
        out_.mesh_face.clear();
        out_.mesh_cell.clear();
        out_.vertex.clear();
        out_.begin.assign(1, 0);
        for (Index cell = begin_; cell < end_; ++cell) {
            cells_.list_own(cell, own_);
            for (Index i = 0; i < own_.size(); ++i)
                append(cells_.own_begin[cell] + i, {cell, own_[i].other}, own_[i].face);
        }
    }
    void append(Index face, std::array<Index, 2> cells, Index of_owner) {
        out_.mesh_face.push_back(face);
        out_.mesh_cell.push_back(cells);
        cells_.append_loop(cells[0], of_owner, out_.vertex);
        if (out_.vertex.size() >= none) fail("a cell has more than 4,294,967,294 corners; leave it out");
        out_.begin.push_back(static_cast<Index>(out_.vertex.size()));
    }
    void list_others(Index cell) {
        others_.clear();
        cells_.for_faces(cell, [&](Index face, Index other) {
            if (other < cell) others_.push_back(shared_face(other, cell, face));
        });
        std::ranges::sort(others_, {}, &Other::face);
        for (const Other& other : others_) {
            out_.cell_loop.push_back(2 * (other.loop == not_listed ? out_.loop_count() : other.loop) + 1);
            if (other.loop == not_listed) append(other.face, {other.owner, cell}, other.of_owner);
        }
    }
    // Returns where a shared face is stored. `face`: input face of `cell` that is also a face of `owner`.
    [[nodiscard]] Other shared_face(Index owner, Index cell, Index face) {
        const Index first = cells_.own_begin[owner];
        if (owner >= begin_) {
            const auto listed =
                std::span(out_.mesh_cell).subspan(first - first_face_, cells_.own_begin[owner + 1] - first);
            const Index i = find(
                listed, [](const auto& of_face) { return of_face[1]; }, owner, cell, face,
                [&](Index own) {
                    const Index loop = first - first_face_ + own;
                    loop_.clear();
                    append_without_repeats(
                        std::span(out_.vertex).subspan(out_.begin[loop], out_.begin[loop + 1] - out_.begin[loop]),
                        loop_);
                });
            return {first + i, first - first_face_ + i, owner, none};
        }
        const std::span<const OwnFace> own = own_faces(owner);
        const Index i =
            find(own, &OwnFace::other, owner, cell, face, [&](Index k) { read(owner, own[k].face, loop_); });
        return {first + i, not_listed, owner, own[i].face};
    }
    // Keeps the lists of large cells, because many cells of the block may share a face with the same large cell.
    [[nodiscard]] std::span<const OwnFace> own_faces(Index cell) {
        constexpr Index large = 64;
        if (cells_.own_begin[cell + 1] - cells_.own_begin[cell] < large) {
            cells_.list_own(cell, own_);
            return own_;
        }
        std::vector<OwnFace>& kept = large_[cell];
        if (kept.empty()) cells_.list_own(cell, kept);
        return kept;
    }
    // Returns the index, among the faces of the owner, of the face that `cell` also has. If the two cells share several
    // faces, the corners are compared. read_loop(i) sets loop_ to the i-th face of the owner.
    template <class Faces, class OtherCell, class ReadLoop>
    [[nodiscard]] Index find(const Faces& faces, OtherCell other_cell, Index owner, Index cell, Index face,
                             ReadLoop&& read_loop) {
        const auto first = static_cast<Index>(std::ranges::lower_bound(faces, cell, {}, other_cell) - faces.begin());
        const auto end = static_cast<Index>(std::ranges::upper_bound(faces, cell, {}, other_cell) - faces.begin());
        if (end - first == 1) return first;
        if (std::exchange(shared_by_, {owner, cell}) != std::array{owner, cell}) {
            by_smallest_.clear();
            for (Index i = first; i < end; ++i) {
                read_loop(i);
                by_smallest_.emplace(*std::ranges::min_element(loop_), i);
            }
        }
        read(cell, face, wanted_);
        const auto [from, to] = by_smallest_.equal_range(*std::ranges::min_element(wanted_));
        for (auto at = from; at != to; ++at) {
            read_loop(at->second);
            if (compare_loops(wanted_, loop_) != Relation::different) return at->second;
        }
        fail("two cells do not agree about a face that they share; please report this mesh");
    }
    void read(Index cell, Index face, std::vector<Index>& loop) {
        raw_.clear();
        cells_.append_loop(cell, face, raw_);
        loop.clear();
        append_without_repeats(raw_, loop);
    }

    const MatchedCells::Data& cells_;
    Index begin_, end_, first_face_;
    FaceLoops& out_;
    std::vector<OwnFace> own_;
    std::unordered_map<Index, std::vector<OwnFace>> large_; // faces of large cells of earlier blocks
    std::array<Index, 2> shared_by_{none, none};            // owner and cell whose shared faces are in by_smallest_
    std::unordered_multimap<Index, Index> by_smallest_;     // smallest vertex -> index among the owner's faces
    std::vector<Other> others_;
    std::vector<Index> raw_, wanted_, loop_;
};

} // namespace

void MatchedCellsSource::list(Index cell_begin, Index cell_end, FaceLoops& out) const {
    Listing(cells_, cell_begin, cell_end, out).run();
}

void MatchedCellsSource::refuse() const {
    fail("the faces of the cells contradict each other; please report this mesh");
}

} // namespace ciel::detail
