// Algorithm 4 of the paper: intersection polygons by turning around the faces of a polyhedron.
// A polygon is a walk over faces of the cell, seen from outside. The walk enters a face at an active edge where the
// loop of the face climbs from low to high. It leaves the face at the next active edge of the loop, which descends, and
// enters the adjacent face across that edge. If a decider joins the high runs of a face, the walk leaves the face at
// the previous active edge instead. A table from entry edge to exit edge (`follow`) is enough, unless the cell touches
// itself along an edge (`walk_all`).
// A record may change at any time (block.hpp). Therefore `spend` limits the steps through faces, `follow` uses each
// entry edge once, and the edges of a polygon are either entry edges, which are active, or checked by `check_active`.
#include "extraction/active_edges.hpp"
#include "extraction/joins_high.hpp"

#include <algorithm>
#include <cmath>

namespace ciel::detail {

namespace {

// Returns a stamp, never 0. Entries of `marks` with another stamp belong to earlier cells and are stale.
template <class Marks>
Index next_stamp(Index& stamp, std::vector<Marks>& marks) {
    // After 2^32 stamps, the numbers repeat. Old entries must not match them.
    if (++stamp == 0) {
        for (Marks& mark : marks) mark.stamp = 0;
        stamp = 1;
    }
    return stamp;
}

template <class Edges, class Local>
class PolyhedronCutter {
public:
    PolyhedronCutter(const PolyhedralSection<Local>& section, const BlockValues& in, CutScratch& scratch,
                     ActiveBlock& cut)
        : section_(section), vertex_(section.vertex.data()), edge_(section.edge.data()), high_(scratch.high.data()),
          in_(in), scratch_(scratch), cut_(cut), edges_(scratch),
          left_(std::uint64_t{visits} * section.half_edge_count()) {}

    void run() {
        if (scratch_.cells == 0) return;
        if (scratch_.way.size() < scratch_.ends.size()) scratch_.way.resize(scratch_.ends.size());
        const std::span cells = scratch_.active_cells();
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (i + 1 < cells.size()) fetch(cells[i + 1].index);
            cut_cell(cells[i].index);
        }
        edges_.finish();
    }

private:
    using Loop = typename PolyhedralSection<Local>::Loop;
    // Number of steps that a cut may take for each half-edge of the section. An unchanged record needs fewer steps.
    static constexpr unsigned visits = 8;

    void spend(std::uint64_t steps) {
        if (steps > left_) [[unlikely]]
            refuse_changed("its cells have more corners than before");
        left_ -= steps;
    }
    void fetch(Index cell) const;
    void cut_cell(Index cell);
    bool has_gap(Index cell);
    [[nodiscard]] std::uint64_t high_corners(Index begin, Index size) const;
    [[nodiscard]] std::span<const CutScratch::CrossedFace> find_crossed(Index cell);
    bool link(Index entry, Index after, Index exit);
    bool link_once(const CutScratch::CrossedFace& face);
    bool link_often(const CutScratch::CrossedFace& face);
    void find_crossings(Loop loop);
    bool is_joined(Loop loop);
    void follow(Index cell);
    void walk_all(Index cell);
    void walk(Index cell, Index start);
    [[nodiscard]] Index exit_of(Loop loop, Index entry, bool forward);
    void finish_walk(Index cell, std::size_t begin);
    void check_active(std::size_t begin) const;
    void finish(Index cell, std::size_t begin);

    [[nodiscard]] bool is_high(Index corner) const { return high_[vertex_[corner]] != 0; }
    [[nodiscard]] bool is_active(Loop loop, Index corner) const {
        return is_high(corner) != is_high(loop.next(corner));
    }
    void activate(Index edge, Index corner, Index next) {
        const Index a = vertex_[corner], b = vertex_[next];
        if (in_.gaps && (std::isnan(in_.values[a]) || std::isnan(in_.values[b]))) return;
        (void)edges_.activate(edge, a, b);
    }

    const PolyhedralSection<Local>& section_;
    const Local *vertex_, *edge_;
    const std::uint8_t* high_;
    const BlockValues& in_;
    CutScratch& scratch_;
    ActiveBlock& cut_;
    Edges edges_;
    std::uint64_t left_; // number of steps that the cut may still take
};

// The faces of a cell are scattered in memory. Without prefetching, waiting for the faces took half of the time.
template <class Edges, class Local>
void PolyhedronCutter<Edges, Local>::fetch(Index cell) const {
    for (const Index ref : section_.faces_of(cell)) {
        const std::size_t first = section_.face_begin[ref / 2];
        __builtin_prefetch(vertex_ + first);
        __builtin_prefetch(edge_ + first);
    }
}

template <class Edges, class Local>
bool PolyhedronCutter<Edges, Local>::has_gap(Index cell) {
    for (const Index ref : section_.faces_of(cell)) {
        const Loop loop = section_.loop(ref / 2);
        spend(loop.size());
        for (Index k = loop.begin; k < loop.end; ++k)
            if (std::isnan(in_.values[vertex_[k]])) return true;
    }
    return false;
}

// Reads eight corners at once, because a loop over the unpredictable number of corners mispredicts branches.
template <class Edges, class Local>
std::uint64_t PolyhedronCutter<Edges, Local>::high_corners(Index begin, Index size) const {
    const Local* vertex = vertex_ + begin;
    std::uint64_t bits = 0;
    if (size <= 8 && begin + 8 <= section_.vertex.size()) {
        for (Index i = 0; i < 8; ++i) bits |= std::uint64_t{high_[vertex[i]]} << i;
        return bits & ((std::uint64_t{1} << size) - 1);
    }
    for (Index i = 0; i < size; ++i) bits |= std::uint64_t{high_[vertex[i]]} << i;
    return bits;
}

// Tests a face again for its second cell, because a cache of the results was slower.
template <class Edges, class Local>
std::span<const CutScratch::CrossedFace> PolyhedronCutter<Edges, Local>::find_crossed(Index cell) {
    const std::span<const Local> faces = section_.faces_of(cell);
    spend(faces.size());
    if (scratch_.crossed.size() <= faces.size()) scratch_.crossed.resize(faces.size() + 1);
    const Local* begin = section_.face_begin.data();
    CutScratch::CrossedFace* to = scratch_.crossed.data();
    for (const Index ref : faces) {
        const Index face = ref / 2, size = begin[face + 1] - begin[face];
        const bool many = size > 64;
        const std::uint64_t here = many ? 0 : high_corners(begin[face], size);
        const std::uint64_t next = here >> 1 | (here & 1) << ((size - 1) % 64);
        *to = {face, ref % 2, many ? ~std::uint64_t{0} : ~here & next, here & ~next};
        to += to->climbs != 0 ? 1 : 0;
    }
    return {scratch_.crossed.data(), to};
}

// Records that a polygon enters a face over the edge at `entry` and leaves it over the edge at `exit`. `after`: the
// corner after `entry` in the stored loop. Activates only the entry edge, because each active edge of the cell is the
// entry edge of some face. Returns false if the edge already is an entry edge in this cell.
template <class Edges, class Local>
bool PolyhedronCutter<Edges, Local>::link(Index entry, Index after, Index exit) {
    const Index edge = read_once(edge_[entry]);
    activate(edge, entry, after);
    CutScratch::Way& way = scratch_.way[edge];
    if (way.stamp == scratch_.cell_stamp) return false;
    way = {scratch_.cell_stamp, edge_[exit]};
    scratch_.entry.push_back(edge);
    return true;
}

// A cell on side 1 sees the stored loop reversed. There, the polygon enters the face at its descending edge.
template <class Edges, class Local>
bool PolyhedronCutter<Edges, Local>::link_once(const CutScratch::CrossedFace& face) {
    const Index begin = section_.face_begin[face.face], end = section_.face_begin[face.face + 1];
    const Index climbing = begin + static_cast<Index>(std::countr_zero(face.climbs));
    const Index descending = begin + static_cast<Index>(std::countr_zero(face.descends));
    const Index entry = face.side == 0 ? climbing : descending, exit = face.side == 0 ? descending : climbing;
    const Index after = entry + 1 == end ? begin : entry + 1;
    if (edge_[entry] != edge_[exit]) return link(entry, after, exit);
    // The face has collapsed to a line. The edge is activated here, because perhaps no other face has the edge.
    const Index edge = read_once(edge_[entry]);
    activate(edge, entry, after);
    scratch_.returning.push_back(edge);
    return true;
}

template <class Edges, class Local>
bool PolyhedronCutter<Edges, Local>::link_often(const CutScratch::CrossedFace& face) {
    const Loop loop = section_.loop(face.face);
    spend(loop.size());
    find_crossings(loop);
    const auto& crossing = scratch_.crossing;
    const std::size_t n = crossing.size(), to_exit = is_joined(loop) ? n - 1 : 1;
    bool simple = true;
    for (std::size_t i = 0; i < n; i += 2) {
        const auto &climbing = crossing[i], &descending = crossing[(i + to_exit) % n];
        simple = (face.side == 0 ? link(climbing[0], climbing[1], descending[0])
                                 : link(descending[0], descending[1], climbing[0])) &&
                 simple;
    }
    return simple;
}

// Sets scratch.crossing in stored order. Climbing and descending edges alternate, and the first edge climbs.
template <class Edges, class Local>
void PolyhedronCutter<Edges, Local>::find_crossings(Loop loop) {
    scratch_.crossing.clear();
    bool high = is_high(loop.begin);
    for (Index k = loop.begin; k < loop.end; ++k) {
        const Index next = loop.next(k);
        const bool next_high = is_high(next);
        if (high != next_high) scratch_.crossing.push_back({k, next});
        high = next_high;
    }
    if (!scratch_.crossing.empty() && is_high(scratch_.crossing.front()[0]))
        std::rotate(scratch_.crossing.begin(), scratch_.crossing.begin() + 1, scratch_.crossing.end());
}

template <class Edges, class Local>
bool PolyhedronCutter<Edges, Local>::is_joined(Loop loop) {
    if (in_.decider == Decider::isolate_high || scratch_.crossing.size() < 4) return false;
    cut_.decided = true;
    return joins_high(loop.size(), in_.nu, [&](std::size_t i) { return in_.values[vertex_[loop.begin + i]]; });
}

template <class Edges, class Local>
void PolyhedronCutter<Edges, Local>::cut_cell(Index cell) {
    scratch_.entry.clear();
    scratch_.returning.clear();
    (void)next_stamp(scratch_.cell_stamp, scratch_.way);
    bool simple = true;
    for (const CutScratch::CrossedFace& face : find_crossed(cell)) {
        const bool once = (face.climbs & (face.climbs - 1)) == 0;
        simple = (once ? link_once(face) : link_often(face)) && simple;
    }
    for (const Index edge : scratch_.returning)
        if (scratch_.way[edge].stamp != scratch_.cell_stamp) cut_.wasted = true;
    if (in_.gaps && has_gap(cell))
        cut_.wasted = true;
    else if (simple)
        follow(cell);
    else
        walk_all(cell);
}

template <class Edges, class Local>
void PolyhedronCutter<Edges, Local>::follow(Index cell) {
    std::vector<Index>& loop = cut_.polygon_edge;
    for (const Index start : scratch_.entry) {
        if (scratch_.way[start].stamp != scratch_.cell_stamp) continue; // the edge is in a polygon already
        const std::size_t begin = loop.size();
        Index edge = start;
        do {
            loop.push_back(edge);
            scratch_.way[edge].stamp = 0;
            edge = scratch_.way[edge].exit;
        } while (scratch_.way[edge].stamp == scratch_.cell_stamp);
        if (edge != start) refuse_changed("a polygon is not closed");
        if (in_.gaps) check_active(begin); // an entry edge to a vertex without a value is not active
        finish(cell, begin);
    }
}

template <class Edges, class Local>
void PolyhedronCutter<Edges, Local>::walk_all(Index cell) {
    const std::size_t half_edges = std::max<std::size_t>(section_.half_edge_count(), 2 * local_ids);
    if (scratch_.walked.size() < half_edges) {
        scratch_.walked.resize(half_edges, 0);
        scratch_.mate.resize(half_edges, none);
    }
    Index left = section_.half_edge_count();
    const bool is_closed =
        scratch_.pairs.run(section_, cell, left, [this](Index h, Index mate, Index) { scratch_.mate[h] = mate; });
    spend(section_.half_edge_count() - left);
    if (!is_closed) {
        cut_.wasted = true;
        return;
    }
    std::vector<Index>& entries = scratch_.entry; // here a list of half-edges, not of edges
    entries.clear();
    for (const Index ref : section_.faces_of(cell)) {
        const Index side = ref % 2;
        const Loop loop = section_.loop(ref / 2);
        spend(loop.size());
        for (Index k = loop.begin; k < loop.end; ++k)
            if (is_active(loop, k) && is_high(k) == (side == 1)) entries.push_back(section_.half_edge(k, side));
    }
    for (const Index h : entries) scratch_.walked[h] = 0;
    for (const Index h : entries)
        if (scratch_.walked[h] == 0) walk(cell, h);
}

template <class Edges, class Local>
void PolyhedronCutter<Edges, Local>::walk(Index cell, Index start) {
    std::vector<Index>& loop = cut_.polygon_edge;
    const std::size_t begin = loop.size();
    Index h = start;
    const auto joined = [this](Loop face) {
        if (in_.decider == Decider::isolate_high) return false;
        find_crossings(face);
        return is_joined(face);
    };
    do {
        if (h >= scratch_.walked.size()) refuse_changed("a half-edge has no mate");
        scratch_.walked[h] = 1;
        const Index corner = section_.corner(h), side = section_.side(h), here = read_once(edge_[corner]);
        if (loop.size() == begin || loop.back() != here) loop.push_back(here);
        const Loop face = section_.loop(section_.face(corner));
        h = scratch_.mate[section_.half_edge(exit_of(face, corner, (side == 0) != joined(face)), side)];
    } while (h != start);
    finish_walk(cell, begin);
}

template <class Edges, class Local>
Index PolyhedronCutter<Edges, Local>::exit_of(Loop loop, Index entry, bool forward) {
    if (!loop.has(entry)) refuse_changed("a face does not have its corners");
    Index corner = entry;
    do {
        spend(1);
        corner = forward ? loop.next(corner) : loop.previous(corner);
    } while (!is_active(loop, corner));
    return corner;
}

// In a cell that touches itself or has collapsed, a walk may pass an edge more than once.
template <class Edges, class Local>
void PolyhedronCutter<Edges, Local>::finish_walk(Index cell, std::size_t begin) {
    std::vector<Index>& loop = cut_.polygon_edge;
    while (loop.size() > begin + 1 && loop.back() == loop[begin]) loop.pop_back();
    const auto first = loop.begin() + static_cast<std::ptrdiff_t>(begin);
    if (std::all_of(first, loop.end(), [&](Index e) { return e == *first || e == *(first + 1); })) {
        loop.resize(begin);
        cut_.wasted = true;
        return;
    }
    check_active(begin);
    finish(cell, begin);
}

// Throws Error if a changed record has led to an edge that is not active.
template <class Edges, class Local>
void PolyhedronCutter<Edges, Local>::check_active(std::size_t begin) const {
    bool active = true;
    for (std::size_t i = begin; i < cut_.polygon_edge.size(); ++i) active &= edges_.has(cut_.polygon_edge[i]);
    if (!active) refuse_changed("a polygon has an edge that is not active");
}

// Seen from outside the cell, the walk has the high side on its left, but the normal must point to the high side.
template <class Edges, class Local>
void PolyhedronCutter<Edges, Local>::finish(Index cell, std::size_t begin) {
    std::vector<Index>& loop = cut_.polygon_edge;
    if (loop.size() - begin < 3) {
        loop.resize(begin);
        cut_.wasted = true;
        return;
    }
    std::reverse(loop.begin() + static_cast<std::ptrdiff_t>(begin), loop.end());
    for (std::size_t i = begin; i < loop.size(); ++i) loop[i] = edges_.kept(loop[i]);
    cut_.polygon_cell.push_back(section_.local_cell(cell));
    cut_.polygon_end.push_back(static_cast<Index>(loop.size()));
}

} // namespace

template <class Edges, class Local>
void cut_polyhedra(const PolyhedralSection<Local>& section, const BlockValues& in, CutScratch& scratch,
                   ActiveBlock& cut) {
    PolyhedronCutter<Edges, Local>(section, in, scratch, cut).run();
}

template void cut_polyhedra<SharedEdges>(const PolyhedralSection<std::uint16_t>&, const BlockValues&, CutScratch&,
                                         ActiveBlock&);
template void cut_polyhedra<SharedEdges>(const PolyhedralSection<std::uint32_t>&, const BlockValues&, CutScratch&,
                                         ActiveBlock&);
template void cut_polyhedra<MetEdges>(const PolyhedralSection<std::uint16_t>&, const BlockValues&, CutScratch&,
                                      ActiveBlock&);
template void cut_polyhedra<MetEdges>(const PolyhedralSection<std::uint32_t>&, const BlockValues&, CutScratch&,
                                      ActiveBlock&);

} // namespace ciel::detail
