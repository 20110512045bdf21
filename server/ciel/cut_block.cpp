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

void CutBlock::clear_polygons() {
    polygon_cell.clear();
    polygon_end.clear();
    polygon_point.clear();
    wasted = false;
}

namespace {

template <class Local>
class Walker {
public:
    Walker(const Block& block, const BlockArrays<Local>& arrays, std::span<const float> values, float threshold,
           CutScratch& scratch, CutBlock& cut)
        : block_(block), arrays_(arrays), values_(values), threshold_(threshold), scratch_(scratch), cut_(cut) {}

    void walk(Index cell) {
        for (Index i = block_.cell_face_begin[cell]; i < block_.cell_face_begin[cell + 1]; ++i) {
            const Index face = arrays_.cell_face[i] / 2, side = arrays_.cell_face[i] % 2;
            const Index begin = block_.face_begin[face], end = block_.face_begin[face + 1];
            for (Index k = begin; k < end; ++k) {
                if (slot(k) == none) continue;
                const Index origin = side == 0 ? k : block_.next_in_loop(k, face);
                if (values_[arrays_.vertex[origin]] >= threshold_) continue; // the loop leaves the high side here
                const Index h = block_.half_edge(k, side);
                if (!scratch_.walked[h]) walk_loop(cell, h);
            }
        }
        for (const Index h : scratch_.trail) scratch_.walked[h] = 0;
        scratch_.trail.clear();
    }

    [[nodiscard]] bool touches_gap(Index cell) const {
        for (Index i = block_.cell_face_begin[cell]; i < block_.cell_face_begin[cell + 1]; ++i) {
            const Index face = arrays_.cell_face[i] / 2;
            for (Index k = block_.face_begin[face]; k < block_.face_begin[face + 1]; ++k)
                if (std::isnan(values_[arrays_.vertex[k]])) return true;
        }
        return false;
    }

private:
    [[nodiscard]] Index slot(Index corner) const { return scratch_.slot[arrays_.edge[corner]]; }

    // Algorithm 4. A face is entered where its loop climbs from low to high and left at the next active edge, where it
    // descends: the high side of every face is cut off by itself, so two cells agree on the face between them.
    void walk_loop(Index cell, Index start) {
        const std::size_t begin = cut_.polygon_point.size();
        Index h = start;
        do {
            scratch_.walked[h] = 1;
            scratch_.trail.push_back(h);
            const Index corner = block_.corner(h);
            if (cut_.polygon_point.size() == begin || cut_.polygon_point.back() != slot(corner))
                cut_.polygon_point.push_back(slot(corner));
            h = arrays_.mate_face[leave_face(corner, block_.side(h))];
        } while (h != start);
        finish_polygon(cell, begin);
    }

    [[nodiscard]] Index leave_face(Index corner, Index side) const {
        const Index face = arrays_.face[corner];
        if (side == 0) do
                corner = block_.next_in_loop(corner, face);
            while (slot(corner) == none);
        else
            do corner = block_.previous_in_loop(corner, face);
            while (slot(corner) == none);
        return block_.half_edge(corner, side);
    }

    // The walk has the high side on its left seen from outside: reversed, the right-hand normal points to it.
    void finish_polygon(Index cell, std::size_t begin) {
        std::vector<Index>& points = cut_.polygon_point;
        while (points.size() > begin + 1 && points.back() == points[begin]) points.pop_back();
        const auto first = points.begin() + static_cast<std::ptrdiff_t>(begin);
        const bool flat = std::all_of(first, points.end(), [&](Index p) { return p == *first || p == *(first + 1); });
        if (flat) {
            points.resize(begin);
            cut_.wasted = true;
            return;
        }
        std::reverse(first + 1, points.end());
        cut_.polygon_cell.push_back(cell);
        cut_.polygon_end.push_back(static_cast<Index>(points.size()));
    }

    const Block& block_;
    const BlockArrays<Local>& arrays_;
    std::span<const float> values_;
    float threshold_;
    CutScratch& scratch_;
    CutBlock& cut_;
};

} // namespace

template <class Local>
void walk_cells(const Block& block, const BlockArrays<Local>& arrays, std::span<const float> values, float threshold,
                bool gaps, std::span<const Index> cells, CutScratch& scratch, CutBlock& cut) {
    if (scratch.walked.size() < arrays.mate_face.size()) scratch.walked.resize(arrays.mate_face.size(), 0);
    cut.clear_polygons();
    Walker walker(block, arrays, values, threshold, scratch, cut);
    for (const Index cell : cells) {
        if (gaps && walker.touches_gap(cell))
            cut.wasted = true;
        else
            walker.walk(cell);
    }
}

template void walk_cells(const Block&, const BlockArrays<std::uint16_t>&, std::span<const float>, float, bool,
                         std::span<const Index>, CutScratch&, CutBlock&);
template void walk_cells(const Block&, const BlockArrays<std::uint32_t>&, std::span<const float>, float, bool,
                         std::span<const Index>, CutScratch&, CutBlock&);

} // namespace ciel
