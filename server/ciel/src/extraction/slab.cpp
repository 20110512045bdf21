#include "ciel/slab.hpp"

#include "blocks/blocks.hpp"
#include "blocks/cell_loops.hpp"
#include "blocks/inner_faces.hpp"
#include "ciel/cell_geometry.hpp"
#include "extraction/join_pieces.hpp"
#include "extraction/polygon.hpp"
#include "extraction/sink_arrays.hpp"
#include "fields/sparse_array.hpp"
#include "parallel/grain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel {

using namespace detail;

namespace {

// The points of the polygons must be vertices of the SlabMesh already.
class FanWriter {
public:
    explicit FanWriter(SlabMesh& out) : out_(out), taken_(taken_of_this_thread()) {
        taken_.assign(out.vertices.size(), 0);
    }

    void add(std::span<const Index> loop, const std::array<float, 2>& limits) {
        if (loop.size() < 3) return;
        const std::size_t corner = best_corner(loop), n = loop.size();
        const Index apex = own(loop[corner]);
        out_.vertices[apex].limits = limits;
        for (std::size_t i = 1; i + 1 < n; ++i)
            out_.triangles.insert(out_.triangles.end(), {apex, loop[(corner + i) % n], loop[(corner + i + 1) % n]});
    }

private:
    // The first vertex of a fan has the limits of one cell; therefore two fans cannot share it.
    [[nodiscard]] Index own(Index point) {
        if (taken_[point] == 0) {
            taken_[point] = 1;
            return point;
        }
        const SlabVertex copy = out_.vertices[point];
        out_.vertices.push_back(copy);
        return static_cast<Index>(out_.vertices.size() - 1);
    }

    [[nodiscard]] static std::vector<std::uint8_t>& taken_of_this_thread() {
        static thread_local std::vector<std::uint8_t> taken;
        return taken;
    }

    // Prefers a corner without reversed triangles. A reversed triangle overlaps others, which are then blended twice.
    [[nodiscard]] std::size_t best_corner(std::span<const Index> loop) const {
        if (loop.size() == 3) return free_corner(loop);
        const Vec3d normal = area_of(loop);
        std::size_t best = 0;
        double best_worst = -std::numeric_limits<double>::infinity();
        const std::size_t step = std::max<std::size_t>(1, loop.size() / 64); // makes the time linear in the corners
        for (std::size_t k = 0, first = free_corner(loop); k < loop.size() && best_worst < 0; k += step) {
            const std::size_t corner = (first + k) % loop.size();
            const double worst = worst_area(loop, normal, corner);
            if (worst > best_worst) {
                best_worst = worst;
                best = corner;
            }
        }
        return best;
    }

    [[nodiscard]] std::size_t free_corner(std::span<const Index> loop) const {
        const auto found = std::ranges::find_if(loop, [&](Index p) { return taken_[p] == 0; });
        return found == loop.end() ? 0 : static_cast<std::size_t>(found - loop.begin());
    }

    [[nodiscard]] Vec3d to(Index from, Index point) const {
        return arm(out_.vertices[from].position, out_.vertices[point].position);
    }
    [[nodiscard]] Vec3d area_of(std::span<const Index> loop) const {
        Vec3d sum{};
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            const Vec3d piece = cross(to(loop[0], loop[i]), to(loop[0], loop[i + 1]));
            for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += piece[axis];
        }
        return sum;
    }
    [[nodiscard]] double worst_area(std::span<const Index> loop, const Vec3d& normal, std::size_t corner) const {
        const std::size_t n = loop.size();
        // The tolerance, 1e-6 of the polygon's area, accepts a sliver that only rounding has reversed.
        double worst = 1e-5 * dot(normal, normal);
        for (std::size_t i = 1; i + 1 < n; ++i)
            worst = std::min(worst, 1e-6 * dot(normal, normal) +
                                        dot(normal, cross(to(loop[corner], loop[(corner + i) % n]),
                                                          to(loop[corner], loop[(corner + i + 1) % n]))));
        return worst;
    }

    SlabMesh& out_;
    std::vector<std::uint8_t>& taken_; // by vertex: 1 if a fan starts at the vertex
};

bool is_filled(const std::array<float, 2>& limits) { return limits[0] <= limits[1]; }

Vec3f lerp(const Vec3f& a, const Vec3f& b, double t) {
    return {ciel::lerp(a[0], b[0], t), ciel::lerp(a[1], b[1], t), ciel::lerp(a[2], b[2], t)};
}

// `take` writes the fans at the end, because FanWriter needs all vertices.
class SlabFaces {
public:
    SlabFaces(const FaceMeshView& points, const SlabProperty& property)
        : points_(points), property_(property), local_(points.vertex_count()) {}

    void add(std::span<const Index> loop, Index cell) {
        points_.load(loop);
        for (const Index vertex : loop) {
            Index& local = local_.get()[vertex];
            if (local == 0) {
                out_.vertices.push_back(
                    {surface_position(points_, vertex), property_.value[vertex], property_.gradient[vertex], {}});
                local = static_cast<Index>(out_.vertices.size());
            }
            corners_.push_back(local - 1);
        }
        ends_.push_back(corners_.size());
        cells_.push_back(cell);
    }
    [[nodiscard]] SlabMesh take() && {
        FanWriter fans(out_);
        for (std::size_t i = 0, begin = 0; i < cells_.size(); begin = ends_[i++])
            fans.add(std::span(corners_).subspan(begin, ends_[i] - begin), property_.limits[cells_[i]]);
        return std::move(out_);
    }

private:
    const FaceMeshView& points_;
    const SlabProperty& property_;
    SparseArray<Index> local_; // by mesh vertex: index in out_.vertices plus 1; 0 if not added
    std::vector<Index> corners_, cells_;
    std::vector<std::size_t> ends_; // by face: end of the face's corners in corners_
    SlabMesh out_;
};

} // namespace

std::vector<std::array<float, 2>> cell_limits(const Topology& topology, std::span<const float> values) {
    require_size(values.size(), topology.counts().vertices, "values, one for each vertex");
    const Topology::Blocks& blocks = topology.blocks();
    std::vector<std::array<float, 2>> limits(topology.counts().cells, not_filled);
    parallel_for(blocks.count(), fair_grain(blocks.count(), 16), [&](std::size_t begin, std::size_t end) {
        CellLoops loops;
        for (std::size_t b = begin; b < end; ++b)
            for_cells(blocks.cells(static_cast<Index>(b)), loops, [&](Index cell, const CellLoops& of_cell) {
                std::array<float, 2> range = not_filled;
                for (const Index vertex : of_cell.vertex) {
                    const float value = values[vertex];
                    if (!std::isfinite(value)) return;
                    range = {std::min(range[0], value), std::max(range[1], value)};
                }
                limits[cell] = range;
            });
    });
    return limits;
}

void SlabSink::check(const FaceMeshView& mesh) const {
    require_size(property.value.size(), mesh.vertex_count(), "values, one for each vertex");
    require_size(property.gradient.size(), mesh.vertex_count(), "gradients, one for each vertex");
    require_size(property.limits.size(), mesh.cell_count(), "limits, one for each cell");
}

void SlabSink::write(const BlockPolygons& cut, Piece& piece) const {
    piece.vertices.clear();
    piece.vertices.reserve(cut.points.size() + cut.polygon_count() / 2);
    for (std::size_t i = 0; i < cut.points.size(); ++i) {
        const auto& [a, b, t] = cut.points[i];
        piece.vertices.push_back({cut.positions[i],
                                  ciel::lerp(property.value[a], property.value[b], t),
                                  lerp(property.gradient[a], property.gradient[b], t),
                                  {}});
    }
    piece.triangles.clear();
    piece.triangles.reserve(3 * (cut.polygon_point.size() - 2 * cut.polygon_count()));
    FanWriter fans(piece);
    for (std::size_t i = 0; i < cut.polygon_count(); ++i)
        if (const auto& limits = property.limits[cut.cell_begin + cut.polygon_cell[i]]; is_filled(limits))
            fans.add(cut.polygon(i), limits);
}

void SlabSink::join(std::span<const Piece* const> pieces, Out& out) const {
    join_arrays(pieces, &Piece::vertices, out);
    join_triangles(pieces, &Piece::vertices, out);
}

SlabMesh slab_boundary(const Topology& topology, const FaceMeshView& boundary, const BlockBoxes& boxes,
                       const SlabProperty& property) {
    if (boundary.vertex_count() != topology.counts().vertices || boundary.cell_count() != topology.counts().cells)
        fail("the boundary of a volume belongs to another mesh than the topology; pass the boundary of the topology's "
             "mesh");
    SlabSink{property}.check(boundary);
    std::vector<std::uint8_t> filled(property.limits.size());
    std::ranges::transform(property.limits, filled.begin(), [](const auto& limits) { return is_filled(limits); });
    const InnerFaces inner(topology, boxes, filled);
    SlabFaces faces(boundary, property);
    std::vector<Index> loop;
    for (Index face = 0; face < boundary.face_count(); ++face) {
        const Index owner = boundary.owner[face];
        if (boundary.neighbour[face] != none || filled[owner] == 0) continue;
        read_loop(boundary, face, loop);
        faces.add(loop, owner);
    }
    inner.for_blocks([&](const InnerFaces::OfBlock& found) {
        for (std::size_t i = 0; i < found.cell.size(); ++i) faces.add(found.loops.face(i), found.cell[i]);
    });
    return std::move(faces).take();
}

} // namespace ciel
