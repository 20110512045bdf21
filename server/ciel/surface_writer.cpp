#include "ciel/surface_writer.hpp"

#include "ciel/parallel.hpp"

#include <algorithm>

namespace ciel {

namespace {

constexpr std::size_t blocks_per_task = 4;

class Writer {
public:
    Writer(const Topology& topology, const FaceMeshView& mesh, const Field::Blocks& field, Cutter& cutter, double nu,
           Surface& out)
        : blocks_(topology.blocks()), mesh_(mesh), field_(field), active_(cutter.active()), cut_(cutter.cut()), nu_(nu),
          out_(out) {}

    void run() {
        number();
        parallel_for(active_.size(), blocks_per_task, [this](std::size_t begin, std::size_t end) {
            std::vector<Index> point;
            for (std::size_t i = begin; i < end; ++i) {
                const Block& block = blocks_.block[active_[i]];
                block.with([&](const auto& arrays) { write_points(active_[i], block, arrays); });
                write_polygons(active_[i], block, point);
            }
        });
        if (std::ranges::any_of(active_, [this](Index b) { return cut_[b].wasted; })) drop_unused_points();
    }

private:
    void number();
    template <class Local>
    void write_points(Index b, const Block& block, const BlockArrays<Local>& arrays);
    void write_polygons(Index b, const Block& block, std::vector<Index>& point);
    [[nodiscard]] Index point_of_ghost(Index edge, Index& owner) const;
    void drop_unused_points();

    const Topology::Blocks& blocks_;
    const FaceMeshView& mesh_;
    const Field::Blocks& field_;
    std::span<const Index> active_;
    std::span<CutBlock> cut_;
    double nu_;
    Surface& out_;
};

void Writer::number() {
    std::uint64_t points = 0, polygons = 0, corners = 0;
    out_.chunks.clear();
    for (const Index b : active_) {
        CutBlock& cut = cut_[b];
        cut.first_point = static_cast<Index>(points);
        cut.first_polygon = static_cast<Index>(polygons);
        cut.first_corner = static_cast<Index>(corners);
        points += cut.owned();
        polygons += cut.polygon_cell.size();
        corners += cut.polygon_point.size();
        if (corners >= none) fail("the surface has more than 4,294,967,294 corners: choose another value");
        if (!cut.polygon_cell.empty()) out_.chunks.push_back({b, cut.first_polygon, static_cast<Index>(polygons)});
    }
    out_.positions.resize(points);
    out_.points.resize(points);
    out_.polygon_offset.resize(polygons + 1);
    out_.polygon_offset[0] = 0;
    out_.polygon_cell.resize(polygons);
    out_.polygon_vertex.resize(corners);
}

template <class Local>
void Writer::write_points(Index b, const Block& block, const BlockArrays<Local>& arrays) {
    const CutBlock& cut = cut_[b];
    const std::span<const float> values = field_.of_block(b);
    for (Index i = 0; i < cut.owned(); ++i) {
        const Index edge = cut.active[cut.ghosts + i];
        const Local low = arrays.edge_low[edge], high = arrays.edge_high[edge];
        const double from = values[low], to = values[high];
        const auto t = static_cast<float>(std::clamp((nu_ - from) / (to - from), 0.0, 1.0));
        const EdgePoint point{block.vertex[low], block.vertex[high], t};
        const float *a = &mesh_.positions[3 * std::size_t{point.a}], *c = &mesh_.positions[3 * std::size_t{point.b}];
        out_.points[cut.first_point + i] = point;
        out_.positions[cut.first_point + i] = {lerp(a[0], c[0], t), lerp(a[1], c[1], t), lerp(a[2], c[2], t)};
    }
}

// Ghosts are sorted by mesh-wide id, so their owners ascend too: `owner` only ever moves on.
Index Writer::point_of_ghost(Index edge, Index& owner) const {
    if (blocks_.edge_begin[owner + 1] <= edge)
        owner = static_cast<Index>(std::ranges::upper_bound(blocks_.edge_begin, edge) - blocks_.edge_begin.begin() - 1);
    const CutBlock& cut = cut_[owner];
    const auto owned = std::span(cut.active).subspan(cut.ghosts);
    const auto local = edge - blocks_.edge_begin[owner] + static_cast<Index>(blocks_.block[owner].ghost_edge.size());
    return cut.first_point + static_cast<Index>(std::ranges::lower_bound(owned, local) - owned.begin());
}

void Writer::write_polygons(Index b, const Block& block, std::vector<Index>& point) {
    const CutBlock& cut = cut_[b];
    point.resize(cut.active.size());
    Index owner = 0;
    for (Index i = 0; i < cut.ghosts; ++i) point[i] = point_of_ghost(block.ghost_edge[cut.active[i]], owner);
    for (Index i = cut.ghosts; i < point.size(); ++i) point[i] = cut.first_point + i - cut.ghosts;
    for (std::size_t i = 0; i < cut.polygon_point.size(); ++i)
        out_.polygon_vertex[cut.first_corner + i] = point[cut.polygon_point[i]];
    for (std::size_t i = 0; i < cut.polygon_cell.size(); ++i) {
        out_.polygon_offset[cut.first_polygon + i + 1] = cut.first_corner + cut.polygon_end[i];
        out_.polygon_cell[cut.first_polygon + i] = block.cell_begin + cut.polygon_cell[i];
    }
}

// Where cells were passed over, an active edge may have no polygon.
void Writer::drop_unused_points() {
    std::vector<Index> renumbered(out_.points.size(), none);
    for (const Index p : out_.polygon_vertex) renumbered[p] = 0;
    Index kept = 0;
    for (std::size_t p = 0; p < renumbered.size(); ++p) {
        if (renumbered[p] == none) continue;
        renumbered[p] = kept;
        out_.points[kept] = out_.points[p];
        out_.positions[kept++] = out_.positions[p];
    }
    out_.points.resize(kept);
    out_.positions.resize(kept);
    for (Index& p : out_.polygon_vertex) p = renumbered[p];
}

} // namespace

void write_surface(const Topology& topology, const FaceMeshView& mesh, const Field::Blocks& field, Cutter& cutter,
                   double nu, Surface& out) {
    Writer(topology, mesh, field, cutter, nu, out).run();
}

} // namespace ciel
