// Algorithm 4 in standard cells: takes the polygons from the table of the shape (standard_cases.hpp), and replaces the
// edges of the shape by the edges of each cell.
#include "extraction/active_edges.hpp"
#include "extraction/joins_high.hpp"
#include "extraction/standard_cases.hpp"

#include <algorithm>
#include <cmath>

namespace ciel::detail {

namespace {

template <const StandardShape& shape, class Edges>
class StandardCutter {
public:
    StandardCutter(const StandardSection& section, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut)
        : section_(section), in_(in), scratch_(scratch), cut_(cut), edges_(scratch),
          cases_(standard_cases<shape>().data()) {}

    void run() {
        if (in_.gaps) pass_over();
        // Each active edge of a cell is in exactly one polygon. A cell has at most four polygons.
        std::size_t polygons = cut_.polygon_cell.size(), corners = cut_.polygon_edge.size();
        const std::size_t first_polygon = polygons, first_corner = corners;
        for (const auto& cell : scratch_.active_cells()) {
            polygons += in_.decider == Decider::isolate_high ? cases_[cell.high].polygons : most_polygons;
            corners += cases_[cell.high].edges;
        }
        cut_.polygon_cell.resize(polygons);
        cut_.polygon_end.resize(polygons);
        cut_.polygon_edge.resize(corners);
        polygon_cell_ = cut_.polygon_cell.data() + first_polygon;
        polygon_end_ = cut_.polygon_end.data() + first_polygon;
        polygon_edge_ = cut_.polygon_edge.data() + first_corner;
        corner_ = static_cast<Index>(first_corner);
        const std::span active = scratch_.active_cells();
        for (std::size_t i = 0; i < active.size(); ++i) {
            if (i + ahead < active.size()) __builtin_prefetch(&section_.edge[active[i + ahead].index * shape.edges]);
            cut_cell(active[i]);
        }
        const auto made = static_cast<std::size_t>(polygon_cell_ - cut_.polygon_cell.data());
        cut_.polygon_cell.resize(made);
        cut_.polygon_end.resize(made);
        edges_.finish();
    }

private:
    static constexpr std::size_t most_polygons = 4, ahead = 8;

    void cut_cell(const CutScratch::ActiveCell& cell) {
        const StandardCase& plain = cases_[cell.high];
        if (in_.decider == Decider::isolate_high || plain.ambiguous == 0) return append(cell, plain);
        cut_.decided = true;
        append(cell, joined_case(shape, cell.high, joined_faces(cell, plain.ambiguous)));
    }

    [[nodiscard]] Index joined_faces(const CutScratch::ActiveCell& cell, Index ambiguous) const {
        const std::uint16_t* vertex = &section_.vertex[cell.index * shape.corners];
        Index joined = 0;
        for (std::size_t face = 0; face < shape.faces; ++face) {
            if ((ambiguous >> face & 1) == 0) continue;
            const auto value = [&](std::size_t i) {
                return in_.values[vertex[shape.origin[shape.face_begin[face] + i]]];
            };
            if (joins_high(shape.face_size(face), in_.nu, value)) joined |= 1U << face;
        }
        return joined;
    }

    void append(const CutScratch::ActiveCell& cell, const StandardCase& found) {
        const std::uint16_t* vertex = &section_.vertex[cell.index * shape.corners];
        const std::uint16_t* edge = &section_.edge[cell.index * shape.edges];
        // A local copy, because the compiler would reload the member after each store through `to`.
        Edges edges = edges_;
        Index* to = polygon_edge_;
        for (std::size_t i = 0; i < found.edges; ++i) {
            const std::size_t e = found.edge[i];
            to[i] = edges.activate(read_once(edge[e]), vertex[shape.edge_ends[e][0]], vertex[shape.edge_ends[e][1]]);
        }
        edges_ = edges;
        for (std::size_t i = 0; i < found.polygons; ++i) {
            *polygon_cell_++ = section_.local_cell(cell.index);
            *polygon_end_++ = corner_ + found.end[i];
        }
        polygon_edge_ += found.edges;
        corner_ += found.edges;
    }

    void pass_over() {
        const std::span active = std::span(scratch_.cell).first(scratch_.cells);
        const auto end =
            std::remove_if(active.begin(), active.end(), [this](const auto& cell) { return passed_over(cell); });
        scratch_.cells -= static_cast<Index>(active.end() - end);
    }

    // Returns whether a corner has no value. If so, activates the crossed edges, because other blocks may use them.
    bool passed_over(const CutScratch::ActiveCell& cell) {
        const std::uint16_t* vertex = &section_.vertex[cell.index * shape.corners];
        const auto has_value = [&](std::size_t corner) { return !std::isnan(in_.values[vertex[corner]]); };
        bool whole = true;
        for (std::size_t c = 0; c < shape.corners; ++c) whole = whole && has_value(c);
        if (whole) return false;
        for (std::size_t e = 0; e < shape.edges; ++e) {
            const auto [a, b] = shape.edge_ends[e];
            if (has_value(a) && has_value(b) && (cell.high >> a & 1) != (cell.high >> b & 1))
                (void)edges_.activate(section_.edge[cell.index * shape.edges + e], vertex[a], vertex[b]);
        }
        cut_.wasted = true;
        return true;
    }

    const StandardSection& section_;
    const BlockValues& in_;
    CutScratch& scratch_;
    ActiveBlock& cut_;
    Edges edges_;
    const StandardCase* cases_;
    Index *polygon_cell_ = nullptr, *polygon_end_ = nullptr, *polygon_edge_ = nullptr;
    Index corner_ = 0;
};

} // namespace

template <class Edges>
void cut_standard(const StandardSection& section, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut) {
    with_shape(section.shape->type,
               [&]<const StandardShape & shape>() { StandardCutter<shape, Edges>(section, in, scratch, cut).run(); });
}

template void cut_standard<SharedEdges>(const StandardSection&, const BlockValues&, CutScratch&, ActiveBlock&);
template void cut_standard<MetEdges>(const StandardSection&, const BlockValues&, CutScratch&, ActiveBlock&);

} // namespace ciel::detail
