#include "ciel/cut_block.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace ciel {

float threshold_of(double nu) {
    if (std::isnan(nu)) return std::numeric_limits<float>::infinity();
    const auto nearest = static_cast<float>(nu);
    return nearest >= nu ? nearest : std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

namespace {

template <class Local>
class Walker {
public:
    Walker(const Block& block, const BlockArrays<Local>& arrays, CutScratch& scratch, CutBlock& cut)
        : block_(block), arrays_(arrays), scratch_(scratch), cut_(cut) {}

    [[nodiscard]] bool walked(Index entry) const { return scratch_.walked[entry] != 0; }
    [[nodiscard]] Index cell_of(Index half_edge) const {
        return arrays_.face_cell[arrays_.face[block_.corner(half_edge)]][block_.side(half_edge)];
    }

    // Algorithm 4. A face is entered where its loop climbs from low to high and left at the next active edge, where it
    // descends: the high side of every face is cut off by itself, so two cells agree on the face between them.
    void walk(Index start) {
        std::vector<Index>& point = scratch_.point;
        const auto begin = static_cast<Index>(point.size());
        Index h = start;
        Index corner = block_.corner(h), side = block_.side(h), face = arrays_.face[corner];
        const Index cell = arrays_.face_cell[face][side];
        do {
            scratch_.walked[h] = 1;
            const Index here = slot(corner);
            if (point.size() == begin || point.back() != here) point.push_back(here);
            if (side == 0) do
                    corner = block_.next_in_loop(corner, face);
                while (slot(corner) == none);
            else
                do corner = block_.previous_in_loop(corner, face);
                while (slot(corner) == none);
            h = arrays_.mate_face[block_.half_edge(corner, side)];
            corner = block_.corner(h);
            side = block_.side(h);
            face = arrays_.face[corner];
        } while (h != start);
        finish(cell, begin);
    }

    // Polygons into `cut`, in their order.
    void write() {
        std::vector<CutScratch::Polygon>& polygon = scratch_.polygon;
        const auto points = [&](const CutScratch::Polygon& p) {
            return std::span(scratch_.point).subspan(p.begin, p.end - p.begin);
        };
        std::ranges::sort(polygon, [&](const CutScratch::Polygon& a, const CutScratch::Polygon& b) {
            return a.cell != b.cell ? a.cell < b.cell : std::ranges::lexicographical_compare(points(a), points(b));
        });
        for (const CutScratch::Polygon& p : polygon) {
            cut_.polygon_cell.push_back(p.cell);
            cut_.polygon_point.insert(cut_.polygon_point.end(), points(p).begin(), points(p).end());
            cut_.polygon_end.push_back(static_cast<Index>(cut_.polygon_point.size()));
        }
    }

private:
    [[nodiscard]] Index slot(Index corner) const { return scratch_.slot[arrays_.edge[corner]]; }

    // The walk has the high side on its left seen from outside: reversed, the right-hand normal points to it.
    void finish(Index cell, Index begin) {
        std::vector<Index>& point = scratch_.point;
        while (point.size() > begin + 1 && point.back() == point[begin]) point.pop_back();
        const auto first = point.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto of_two = [&](Index p) { return p == *first || p == *(first + 1); };
        if (std::all_of(first, point.end(), of_two)) {
            point.resize(begin);
            cut_.wasted = true;
            return;
        }
        std::reverse(first, point.end());
        rotate_to_least(first, point.end());
        scratch_.polygon.push_back({cell, begin, static_cast<Index>(point.size())});
    }

    // Where the loop passes its least point more than once, the rotation that compares least.
    static void rotate_to_least(std::vector<Index>::iterator first, std::vector<Index>::iterator last) {
        const auto least = std::min_element(first, last);
        const bool once = std::find(least + 1, last, *least) == last;
        std::rotate(first, least, last);
        if (once) return;
        std::vector<Index> best(first, last), other = best;
        for (std::size_t turn = 1; turn < best.size(); ++turn) {
            std::rotate(other.begin(), other.begin() + 1, other.end());
            best = std::min(best, other);
        }
        std::copy(best.begin(), best.end(), first);
    }

    const Block& block_;
    const BlockArrays<Local>& arrays_;
    CutScratch& scratch_;
    CutBlock& cut_;
};

// One flag per local cell: it touches a vertex without a value.
template <class Local>
std::vector<std::uint8_t> cells_at_gaps(const Block& block, const BlockArrays<Local>& arrays,
                                        std::span<const float> values) {
    std::vector<std::uint8_t> out(block.cell_count, 0);
    for (std::size_t k = 0; k < arrays.vertex.size(); ++k)
        if (std::isnan(values[arrays.vertex[k]]))
            for (const Local cell : arrays.face_cell[arrays.face[k]]) out[cell] = 1;
    return out;
}

} // namespace

template <class Local>
void walk_entries(const Block& block, const BlockArrays<Local>& arrays, std::span<const float> values, bool gaps,
                  CutScratch& scratch, CutBlock& cut) {
    if (scratch.slot.size() < arrays.edge_low.size()) scratch.slot.resize(arrays.edge_low.size(), none);
    if (scratch.walked.size() < arrays.mate_face.size()) scratch.walked.resize(arrays.mate_face.size(), 0);
    for (Index i = 0; i < cut.active.size(); ++i) scratch.slot[cut.active[i]] = i;
    cut.ghosts = static_cast<Index>(std::ranges::lower_bound(cut.active, block.ghost_edge.size()) - cut.active.begin());
    cut.polygon_cell.clear();
    cut.polygon_end.clear();
    cut.polygon_point.clear();
    cut.wasted = false;
    scratch.point.clear();
    scratch.polygon.clear();

    std::vector<std::uint8_t> passed_over;
    if (gaps) passed_over = cells_at_gaps(block, arrays, values);
    Walker walker(block, arrays, scratch, cut);
    for (const Index h : scratch.entry) {
        if (walker.walked(h)) continue;
        if (gaps && passed_over[walker.cell_of(h)])
            cut.wasted = true;
        else
            walker.walk(h);
    }
    walker.write();
    for (const Index h : scratch.entry) scratch.walked[h] = 0;
    for (const Index e : cut.active) scratch.slot[e] = none;
}

template void walk_entries(const Block&, const BlockArrays<std::uint16_t>&, std::span<const float>, bool, CutScratch&,
                           CutBlock&);
template void walk_entries(const Block&, const BlockArrays<std::uint32_t>&, std::span<const float>, bool, CutScratch&,
                           CutBlock&);

} // namespace ciel
