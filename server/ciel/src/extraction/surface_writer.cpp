#include "extraction/surface_writer.hpp"

#include "blocks/load_vertices.hpp"
#include "ciel/of_this_thread.hpp"
#include "extraction/edge_points.hpp"
#include "extraction/polygon.hpp"
#include "parallel/grain.hpp"

#include <algorithm>
#include <string>

namespace ciel::detail {

namespace {

constexpr std::size_t most_blocks_per_task = 4;
constexpr std::size_t ahead = 8; // number of points between a prefetch and its use

struct PointNumbers {
    std::vector<Index> point; // scratch of write_polygons
};

[[noreturn]] void refuse_ghost(Index owner) {
    fail("block " + std::to_string(owner) +
         " of the mesh does not have an edge that another block refers to; import the dataset again");
}

class Writer {
public:
    Writer(const Topology& topology, const FaceMeshView& mesh, const Field::Data& field, Cutter& cutter, double nu,
           std::optional<Normals> normals, SurfaceScratch& scratch, Surface& out)
        : blocks_(topology.blocks()), mesh_(mesh), field_(field), cutter_(cutter), active_(cutter.active()),
          cut_(cutter.cut()), nu_(nu), normals_(normals), scratch_(scratch), out_(out) {}

    void run() {
        scratch_.adopted.find(blocks_, cutter_);
        number();
        if (normals_ == Normals::gradient) field_.gradients.make_at(mesh_, field_, active_, cut_);
        parallel_for(active_.size(), fair_grain(active_.size(), most_blocks_per_task),
                     [this](std::size_t begin, std::size_t end) {
                         std::vector<Index>& point = of_this_thread<PointNumbers>().point;
                         for (std::size_t i = begin; i < end; ++i) {
                             const Block& block = blocks_.cells(active_[i]);
                             write_points(active_[i], block);
                             if (normals_ == Normals::gradient) write_normals(active_[i]);
                             write_polygons(active_[i], block, point);
                         }
                     });
        write_adopted();
        if (normals_ == Normals::polygons) {
            list_ranges();
            write_polygon_normals(scratch_, out_);
        }
        if (std::ranges::any_of(active_, [this](Index b) { return cut_[b].wasted; })) drop_unused_points();
        if (normals_ == Normals::gradient) mend_normals(scratch_, out_);
    }

private:
    void number();
    void write_points(Index b, const Block& block);
    void write_normals(Index b);
    void write_normal(const ActiveBlock& cut, const Vec3f* gradient, Index end, Index point);
    void write_adopted();
    void write_polygons(Index b, const Block& block, std::vector<Index>& point);
    struct Owner {
        // edge_begin, edges: the first id and the number of the edges that the block owns.
        Index block = 0, edge_begin = 0, edges = 0, ghosts = 0;
        bool is_left_out = false;
    };
    [[nodiscard]] Index point_of_ghost(Index edge, Owner& owner) const;
    void list_ranges();
    void drop_unused_points();

    const Topology::Blocks& blocks_;
    const FaceMeshView& mesh_;
    const Field::Data& field_;
    Cutter& cutter_;
    std::span<const Index> active_;
    BlockCuts& cut_;
    double nu_;
    std::optional<Normals> normals_;
    SurfaceScratch& scratch_;
    Surface& out_;
};

void Writer::number() {
    std::uint64_t points = 0, polygons = 0, corners = 0;
    out_.chunks.clear();
    AdoptedEdges& adopted = scratch_.adopted;
    for (const Index b : active_) {
        ActiveBlock& cut = cut_[b];
        points = adopted.number_below(blocks_.numbers.edge[b], points);
        cut.first_point = static_cast<Index>(points);
        cut.first_polygon = static_cast<Index>(polygons);
        cut.first_corner = static_cast<Index>(corners);
        points += cut.owned();
        polygons += cut.polygon_cell.size();
        corners += cut.polygon_edge.size();
        if (corners >= none) fail("the surface has more than 4,294,967,294 corners; choose another value");
        if (!cut.polygon_cell.empty()) out_.chunks.push_back({b, cut.first_polygon, static_cast<Index>(polygons)});
    }
    out_.positions.resize(points);
    out_.points.resize(points);
    out_.normals.resize(normals_ ? points : 0);
    out_.polygon_offset.resize(polygons + 1);
    out_.polygon_offset[0] = 0;
    out_.polygon_cell.resize(polygons);
    out_.polygon_vertex.resize(corners);
}

void Writer::write_points(Index b, const Block& block) {
    const ActiveBlock& cut = cut_[b];
    load_vertices(mesh_.loader, b, block);
    const ValuesView values = field_.of_block(b);
    const std::span ends = std::span(cut.ends).subspan(cut.ghosts);
    const std::span points = std::span(out_.points).subspan(cut.first_point, ends.size());
    const auto write = [&, shift = mesh_.surface_shift()](const auto& all, const auto& positions) {
        const auto find_vertices = [&](std::size_t i) {
            points[i].a = block.vertex(ends[i][0]);
            points[i].b = block.vertex(ends[i][1]);
            __builtin_prefetch(&positions[3 * std::size_t{points[i].a}]);
            __builtin_prefetch(&positions[3 * std::size_t{points[i].b}]);
        };
        for (std::size_t i = 0; i < std::min(ahead, points.size()); ++i) find_vertices(i);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i + ahead < points.size()) find_vertices(i + ahead);
            points[i].t = share_at(nu_, all[ends[i][0]], all[ends[i][1]]);
            out_.positions[cut.first_point + i] = position_of(points[i], positions, shift);
        }
    };
    values.with([&](const auto& all) { mesh_.positions.with([&](const auto& positions) { write(all, positions); }); });
}

void Writer::write_normals(Index b) {
    const ActiveBlock& cut = cut_[b];
    const Vec3f* gradient = field_.gradients.of_block(b);
    for (Index i = 0; i < cut.owned(); ++i) write_normal(cut, gradient, cut.ghosts + i, cut.first_point + i);
}

void Writer::write_normal(const ActiveBlock& cut, const Vec3f* gradient, Index end, Index point) {
    const auto [low, high] = cut.ends[end];
    const Vec3f &from = gradient[low], &to = gradient[high];
    const double t = out_.points[point].t;
    Vec3d between{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        between[axis] = from[axis] + t * (static_cast<double>(to[axis]) - from[axis]);
    out_.normals[point] = unit(between);
}

// An adopted edge (AdoptedEdges) is in an active block. write_points has already loaded the positions of that block.
void Writer::write_adopted() {
    const std::span<const AdoptedEdges::Edge> edges = scratch_.adopted.edges();
    parallel_for(edges.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (const auto& edge : edges.subspan(begin, end - begin)) {
            const ActiveBlock& cut = cut_[edge.block];
            const EdgePoint point =
                edge_point(blocks_.cells(edge.block), field_.of_block(edge.block), cut.ends[edge.end], nu_);
            out_.points[edge.point] = point;
            out_.positions[edge.point] =
                mesh_.positions.with([&](const auto& all) { return position_of(point, all, mesh_.surface_shift()); });
            if (normals_ == Normals::gradient)
                write_normal(cut, field_.gradients.of_block(edge.block), edge.end, edge.point);
        }
    });
}

// `edge`: mesh-wide id. `owner`: owner of the previous ghost edge; updated. Ghost edges are sorted, so the owner seldom
// changes. Throws Error if the records of the two blocks contradict each other.
Index Writer::point_of_ghost(Index edge, Owner& owner) const {
    // Also true if edge < edge_begin, because the difference then wraps around.
    if (edge - owner.edge_begin >= owner.edges) {
        const std::vector<Index>& begin = blocks_.numbers.edge;
        owner.block = static_cast<Index>(std::ranges::upper_bound(begin, edge) - begin.begin() - 1);
        owner.edge_begin = begin[owner.block];
        owner.edges = begin[owner.block + 1] - owner.edge_begin;
        owner.is_left_out = !cutter_.has(owner.block);
        if (!owner.is_left_out) {
            if (!std::ranges::binary_search(active_, owner.block)) refuse_ghost(owner.block);
            owner.ghosts = static_cast<Index>(blocks_.cells(owner.block).ghost_edge.size());
        }
    }
    if (owner.is_left_out) return scratch_.adopted.point_of(edge);
    const ActiveBlock& cut = cut_[owner.block];
    const Index local = edge - owner.edge_begin + owner.ghosts;
    if ((cut.active[local / 64] >> local % 64 & 1) == 0) [[unlikely]]
        refuse_ghost(owner.block);
    return cut.first_point + cut.place(local) - cut.ghosts;
}

// `point`: a buffer for the surface point of each local edge.
void Writer::write_polygons(Index b, const Block& block, std::vector<Index>& point) {
    const ActiveBlock& cut = cut_[b];
    point.resize(64 * cut.active.size());
    Owner owner;
    Index i = 0;
    for (std::size_t w = 0; w < cut.active.size(); ++w)
        for (std::uint64_t bits = cut.active[w]; bits != 0; bits &= bits - 1, ++i) {
            const auto edge = static_cast<Index>(64 * w) + static_cast<Index>(std::countr_zero(bits));
            point[edge] =
                i < cut.ghosts ? point_of_ghost(block.ghost_edge[edge], owner) : cut.first_point + i - cut.ghosts;
        }
    for (std::size_t k = 0; k < cut.polygon_edge.size(); ++k)
        out_.polygon_vertex[cut.first_corner + k] = point[cut.polygon_edge[k]];
    for (std::size_t k = 0; k < cut.polygon_cell.size(); ++k) {
        out_.polygon_offset[cut.first_polygon + k + 1] = cut.first_corner + cut.polygon_end[k];
        out_.polygon_cell[cut.first_polygon + k] = block.cell_begin + cut.polygon_cell[k];
    }
}

void Writer::list_ranges() {
    scratch_.ranges.clear();
    for (const Index b : active_) {
        const ActiveBlock& cut = cut_[b];
        scratch_.ranges.push_back({cut.first_polygon, cut.first_polygon + static_cast<Index>(cut.polygon_cell.size()),
                                   cut.first_point, cut.first_point + cut.owned()});
    }
}

// Unused points lie on active edges of cells that were skipped or have collapsed.
void Writer::drop_unused_points() {
    std::vector<Index>& renumbered = scratch_.renumbered;
    renumbered.assign(out_.points.size(), none);
    for (const Index p : out_.polygon_vertex) renumbered[p] = 0;
    Index kept = 0;
    for (std::size_t p = 0; p < renumbered.size(); ++p) {
        if (renumbered[p] == none) continue;
        renumbered[p] = kept;
        out_.points[kept] = out_.points[p];
        out_.positions[kept] = out_.positions[p];
        if (normals_) out_.normals[kept] = out_.normals[p];
        ++kept;
    }
    if (normals_) out_.normals.resize(kept);
    out_.points.resize(kept);
    out_.positions.resize(kept);
    for (Index& p : out_.polygon_vertex) p = renumbered[p];
}

} // namespace

void write_surface(const Topology& topology, const FaceMeshView& mesh, const Field::Data& field, Cutter& cutter,
                   double nu, std::optional<Normals> normals, SurfaceScratch& scratch, Surface& out) {
    Writer(topology, mesh, field, cutter, nu, normals, scratch, out).run();
}

} // namespace ciel::detail
