// Algorithm 4 of the paper: intersection polygons by turning around the faces of a polyhedron.
//
// A face is entered where its loop, seen from outside, climbs from low to high, and left at the next active edge, where
// it descends: the high side of every face is cut off by itself, so two cells agree on the face between them. Over that
// edge the polygon goes on in another face of the cell. Where every active edge of the cell is entered once, it is
// enough to note for each where the face behind it is left; where the cell touches itself, mate_face tells the ways
// apart. A decider may join the high sides of a face instead: then it is left at the active edge before.
#include "ciel/cut_block.hpp"

#include <algorithm>
#include <cmath>

namespace ciel {

namespace {

template <class Local>
class PolyhedronCutter {
public:
    PolyhedronCutter(const PolyhedralSection<Local>& section, const BlockValues& in, CutScratch& scratch, CutBlock& cut)
        : section_(section), in_(in), scratch_(scratch), cut_(cut) {}

    void run() {
        if (scratch_.cell.empty()) return;
        const std::size_t edges = 64 * cut_.active.size();
        if (scratch_.entered.size() < edges) {
            scratch_.entered.resize(edges, 0);
            scratch_.exit.resize(edges);
        }
        scratch_.face_pairs.assign(section_.face_count(), none);
        scratch_.pair.clear();
        for (const auto& cell : scratch_.cell) cut_cell(cell.index);
    }

private:
    using Pair = CutScratch::Pair;

    void cut_cell(Index cell);
    bool has_gap(Index cell) const;
    std::span<const Pair> pairs_of(Index face);
    void find_crossings(Index face);
    bool is_joined(Index face);
    bool link_face(std::span<const Pair> pairs, Index side);
    void follow(Index cell);
    void walk_all(Index cell);
    void walk(Index cell, Index start);
    void finish(Index cell, std::size_t begin);

    [[nodiscard]] bool is_high(Index corner) const { return scratch_.high[section_.vertex[corner]] != 0; }
    [[nodiscard]] bool is_active(Index corner, Index face) const {
        return is_high(corner) != is_high(section_.next_in_loop(corner, face));
    }
    void activate(Index corner, Index next) {
        const Index edge = section_.edge[corner], a = section_.vertex[corner], b = section_.vertex[next];
        if (in_.gaps && (std::isnan(in_.values[a]) || std::isnan(in_.values[b]))) return;
        cut_.active[edge / 64] |= std::uint64_t{1} << edge % 64;
        scratch_.ends[edge] = {std::min(a, b), std::max(a, b)};
    }

    const PolyhedralSection<Local>& section_;
    const BlockValues& in_;
    CutScratch& scratch_;
    CutBlock& cut_;
};

template <class Local>
bool PolyhedronCutter<Local>::has_gap(Index cell) const {
    for (const Index ref : section_.faces_of(cell))
        for (Index k = section_.face_begin[ref / 2]; k < section_.face_begin[ref / 2 + 1]; ++k)
            if (std::isnan(in_.values[section_.vertex[k]])) return true;
    return false;
}

// The active edges of a face along its stored loop; climbing and descending ones alternate, and a climbing one is
// first.
template <class Local>
void PolyhedronCutter<Local>::find_crossings(Index face) {
    scratch_.crossing.clear();
    const Index begin = section_.face_begin[face], end = section_.face_begin[face + 1];
    bool high = is_high(begin);
    for (Index k = begin; k < end; ++k) {
        const Index next = k + 1 == end ? begin : k + 1;
        const bool next_high = is_high(next);
        if (high != next_high) scratch_.crossing.push_back({k, next});
        high = next_high;
    }
    if (!scratch_.crossing.empty() && is_high(scratch_.crossing.front()[0]))
        std::rotate(scratch_.crossing.begin(), scratch_.crossing.begin() + 1, scratch_.crossing.end());
}

template <class Local>
bool PolyhedronCutter<Local>::is_joined(Index face) {
    if (in_.decider == Decider::isolate_high || scratch_.crossing.size() < 4) return false;
    cut_.decided = true;
    const Index begin = section_.face_begin[face];
    return joins_high(section_.face_begin[face + 1] - begin, in_.nu,
                      [&](std::size_t i) { return double{in_.values[section_.vertex[begin + i]]}; });
}

// What two cells see of a face, found once: which climbing edge and which descending edge, along the stored loop, the
// surface joins.
template <class Local>
std::span<const CutScratch::Pair> PolyhedronCutter<Local>::pairs_of(Index face) {
    std::vector<Pair>& all = scratch_.pair;
    if (scratch_.face_pairs[face] == none) {
        scratch_.face_pairs[face] = static_cast<Index>(all.size());
        find_crossings(face);
        const auto& crossing = scratch_.crossing;
        const std::size_t n = crossing.size();
        all.push_back({static_cast<Index>(n / 2), 0}); // how many follow
        const bool joined = is_joined(face);
        for (std::size_t i = 0; i < n; i += 2)
            all.push_back(
                {section_.edge[crossing[i][0]], section_.edge[crossing[joined ? (i + n - 1) % n : i + 1][0]]});
        for (const auto& [corner, next] : crossing) activate(corner, next);
    }
    const std::size_t begin = scratch_.face_pairs[face];
    return std::span(all).subspan(begin + 1, all[begin].climbing);
}

// From each entry to its exit: against the loop, what descends along it climbs. False where an edge is entered a second
// time in this cell.
template <class Local>
bool PolyhedronCutter<Local>::link_face(std::span<const Pair> pairs, Index side) {
    for (const Pair& pair : pairs) {
        const Index in = side == 0 ? pair.climbing : pair.descending;
        if (scratch_.entered[in] == scratch_.stamp) return false;
        scratch_.entered[in] = scratch_.stamp;
        scratch_.exit[in] = side == 0 ? pair.descending : pair.climbing;
        scratch_.entry.push_back(in);
    }
    return true;
}

template <class Local>
void PolyhedronCutter<Local>::cut_cell(Index cell) {
    const bool gap = in_.gaps && has_gap(cell);
    scratch_.entry.clear();
    if (++scratch_.stamp == 0) { // after four thousand million cells old stamps would come round
        std::ranges::fill(scratch_.entered, 0);
        scratch_.stamp = 1;
    }
    bool simple = true;
    for (const Index ref : section_.faces_of(cell)) {
        const std::span<const Pair> pairs = pairs_of(ref / 2);
        // A face that collapsed to a line leads from an edge to itself.
        const bool line = section_.face_begin[ref / 2 + 1] - section_.face_begin[ref / 2] == 2;
        if (!line && !gap) simple = simple && link_face(pairs, ref % 2);
    }
    if (gap)
        cut_.wasted = true;
    else if (simple)
        follow(cell);
    else
        walk_all(cell);
}

template <class Local>
void PolyhedronCutter<Local>::follow(Index cell) {
    std::vector<Index>& loop = cut_.polygon_edge;
    for (const Index start : scratch_.entry) {
        if (scratch_.entered[start] != scratch_.stamp) continue; // part of a polygon by now
        const std::size_t begin = loop.size();
        Index edge = start;
        do {
            loop.push_back(edge);
            scratch_.entered[edge] = 0;
            edge = scratch_.exit[edge];
        } while (edge != start);
        finish(cell, begin);
    }
}

template <class Local>
void PolyhedronCutter<Local>::walk_all(Index cell) {
    if (scratch_.walked.size() < 2 * section_.mate_face.size())
        scratch_.walked.resize(2 * section_.mate_face.size(), 0);
    std::vector<Index> entries;
    for (const Index ref : section_.faces_of(cell)) {
        const Index face = ref / 2, side = ref % 2;
        for (Index k = section_.face_begin[face]; k < section_.face_begin[face + 1]; ++k)
            if (is_active(k, face) && is_high(k) == (side == 1)) entries.push_back(section_.half_edge(k, side));
    }
    for (const Index h : entries)
        if (scratch_.walked[h] == 0) walk(cell, h);
    for (const Index h : entries) scratch_.walked[h] = 0;
}

template <class Local>
void PolyhedronCutter<Local>::walk(Index cell, Index start) {
    std::vector<Index>& loop = cut_.polygon_edge;
    const std::size_t begin = loop.size();
    Index h = start;
    const auto joined = [this](Index face) {
        if (in_.decider == Decider::isolate_high) return false;
        find_crossings(face);
        return is_joined(face);
    };
    do {
        scratch_.walked[h] = 1;
        Index corner = section_.corner(h);
        const Index side = section_.side(h), face = section_.face(corner), here = section_.edge[corner];
        if (loop.size() == begin || loop.back() != here) loop.push_back(here);
        const bool forward = (side == 0) != joined(face);
        do corner = forward ? section_.next_in_loop(corner, face) : section_.previous_in_loop(corner, face);
        while (!is_active(corner, face));
        h = section_.mate(section_.half_edge(corner, side));
    } while (h != start);
    finish(cell, begin);
}

// The walk has the high side on its left seen from outside: reversed, the right-hand normal points to it.
template <class Local>
void PolyhedronCutter<Local>::finish(Index cell, std::size_t begin) {
    std::vector<Index>& loop = cut_.polygon_edge;
    while (loop.size() > begin + 1 && loop.back() == loop[begin]) loop.pop_back();
    const auto first = loop.begin() + static_cast<std::ptrdiff_t>(begin);
    if (std::all_of(first, loop.end(), [&](Index e) { return e == *first || e == *(first + 1); })) {
        loop.resize(begin);
        cut_.wasted = true;
        return;
    }
    std::reverse(first, loop.end());
    cut_.polygon_cell.push_back(section_.local_cell(cell));
    cut_.polygon_end.push_back(static_cast<Index>(loop.size()));
}

} // namespace

template <class Local>
void cut_polyhedra(const PolyhedralSection<Local>& section, const BlockValues& in, CutScratch& scratch, CutBlock& cut) {
    PolyhedronCutter<Local>(section, in, scratch, cut).run();
}

template void cut_polyhedra(const PolyhedralSection<std::uint16_t>&, const BlockValues&, CutScratch&, CutBlock&);
template void cut_polyhedra(const PolyhedralSection<std::uint32_t>&, const BlockValues&, CutScratch&, CutBlock&);

} // namespace ciel
