#include "geometry/slab_sink.hpp"

#include "ciel/cell_limits.hpp"
#include "ciel/of_this_thread.hpp"
#include "ciel/sink_pieces.hpp"
#include "ciel/threshold_surface.hpp"
#include "ciel/vectors.hpp"

#include <algorithm>
#include <limits>

namespace server::geometry {

using color::SlabTriangles;
using color::SlabVertex;

namespace {

// Writes polygons as triangle fans. The points of the polygons must be vertices of the SlabTriangles already.
class FanWriter {
public:
    explicit FanWriter(SlabTriangles& out) : out_(out), taken_(taken_of_this_thread()) {
        taken_.assign(out.vertices.size(), 0);
    }

    void add(std::span<const ciel::Index> loop, const std::array<float, 2>& limits) {
        if (loop.size() < 3 || limits[0] > limits[1]) return;
        const std::size_t corner = best_corner(loop), n = loop.size();
        const ciel::Index apex = own(loop[corner]);
        out_.vertices[apex].limits = limits;
        for (std::size_t i = 1; i + 1 < n; ++i)
            out_.triangles.insert(out_.triangles.end(), {apex, loop[(corner + i) % n], loop[(corner + i + 1) % n]});
    }

private:
    // Returns `point`, or a copy of it if another fan starts at `point`. The first vertex of a fan has the limits of
    // one cell, so two fans cannot share it.
    [[nodiscard]] ciel::Index own(ciel::Index point) {
        if (taken_[point] == 0) {
            taken_[point] = 1;
            return point;
        }
        const SlabVertex copy = out_.vertices[point];
        out_.vertices.push_back(copy);
        return static_cast<ciel::Index>(out_.vertices.size() - 1);
    }

    [[nodiscard]] static std::vector<std::uint8_t>& taken_of_this_thread() {
        struct Taken {
            std::vector<std::uint8_t> by_point;
        };
        return ciel::of_this_thread<Taken>().by_point;
    }

    // Prefers a corner without reversed triangles. A reversed triangle overlaps others, which are then blended twice.
    [[nodiscard]] std::size_t best_corner(std::span<const ciel::Index> loop) const {
        if (loop.size() == 3) return free_corner(loop);
        const ciel::Vec3d normal = area_of(loop);
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

    [[nodiscard]] std::size_t free_corner(std::span<const ciel::Index> loop) const {
        const auto found = std::ranges::find_if(loop, [&](ciel::Index p) { return taken_[p] == 0; });
        return found == loop.end() ? 0 : static_cast<std::size_t>(found - loop.begin());
    }

    [[nodiscard]] ciel::Vec3d to(ciel::Index from, ciel::Index point) const {
        return ciel::arm(out_.vertices[from].position, out_.vertices[point].position);
    }
    [[nodiscard]] ciel::Vec3d area_of(std::span<const ciel::Index> loop) const {
        ciel::Vec3d sum{};
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            const ciel::Vec3d piece = ciel::cross(to(loop[0], loop[i]), to(loop[0], loop[i + 1]));
            for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += piece[axis];
        }
        return sum;
    }
    [[nodiscard]] double worst_area(std::span<const ciel::Index> loop, const ciel::Vec3d& normal,
                                    std::size_t corner) const {
        const std::size_t n = loop.size();
        // The tolerance, 1e-6 of the polygon's area, accepts a sliver that only rounding has reversed.
        double worst = 1e-5 * ciel::dot(normal, normal);
        for (std::size_t i = 1; i + 1 < n; ++i)
            worst = std::min(worst, 1e-6 * ciel::dot(normal, normal) +
                                        ciel::dot(normal, ciel::cross(to(loop[corner], loop[(corner + i) % n]),
                                                                      to(loop[corner], loop[(corner + i + 1) % n]))));
        return worst;
    }

    SlabTriangles& out_;
    std::vector<std::uint8_t>& taken_; // by vertex: 1 if a fan starts at the vertex
};

ciel::Vec3f lerp(const ciel::Vec3f& a, const ciel::Vec3f& b, double t) {
    return {ciel::lerp(a[0], b[0], t), ciel::lerp(a[1], b[1], t), ciel::lerp(a[2], b[2], t)};
}

} // namespace

void SlabSink::check(const ciel::TopologyCounts& counts) const {
    ciel::require_size(property.value.size(), counts.vertices, "values, one for each vertex");
    ciel::require_size(property.gradient.size(), counts.vertices, "gradients, one for each vertex");
    ciel::require_size(property.filled.size(), counts.cells, "flags, one for each cell");
}

void SlabSink::write(const ciel::BlockPolygons& cut, Piece& piece) const {
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
    ciel::CellLimits limits(property.topology);
    for (std::size_t i = 0; i < cut.polygon_count(); ++i)
        if (const ciel::Index cell = cut.cell_begin + cut.polygon_cell[i]; property.filled[cell] != 0)
            fans.add(cut.polygon(i), limits.of(cell, property.value));
}

void SlabSink::join(std::span<const Piece* const> pieces, Out& out) const {
    ciel::join_arrays(pieces, &Piece::vertices, out);
    ciel::join_triangles(pieces, &Piece::vertices, out);
}

std::vector<std::uint8_t> filled_cells(const ciel::Field& values) {
    constexpr double greatest = std::numeric_limits<double>::max();
    return ciel::cells_in_range(values, {-greatest, greatest}, ciel::InRange::all);
}

SlabTriangles slab_boundary(const ciel::Surface& faces, const SlabProperty& property) {
    const std::size_t vertices = std::min(property.value.size(), property.gradient.size());
    const auto has_entry = [&](const ciel::EdgePoint& point) { return point.a < vertices; };
    const auto has_cell = [&](ciel::Index cell) { return cell < property.topology.counts().cells; };
    if (!std::ranges::all_of(faces.points, has_entry) || !std::ranges::all_of(faces.polygon_cell, has_cell))
        ciel::fail("the property has no value for a vertex or a cell of the boundary; pass the boundary of the mesh on "
                   "which the property lies");
    SlabTriangles out;
    out.vertices.reserve(faces.points.size() + faces.polygon_cell.size() / 2);
    for (std::size_t i = 0; i < faces.points.size(); ++i) {
        const ciel::Index vertex = faces.points[i].a;
        out.vertices.push_back({faces.positions[i], property.value[vertex], property.gradient[vertex], {}});
    }
    FanWriter fans(out);
    ciel::CellLimits limits(property.topology);
    for (std::size_t i = 0; i < faces.polygon_cell.size(); ++i) {
        const ciel::Index begin = faces.polygon_offset[i], end = faces.polygon_offset[i + 1];
        fans.add(std::span(faces.polygon_vertex).subspan(begin, end - begin),
                 limits.of(faces.polygon_cell[i], property.value));
    }
    return out;
}

} // namespace server::geometry
