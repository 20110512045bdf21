#include "ciel/geometric_vertices.hpp"

#include "blocks/blocks.hpp"
#include "blocks/pair_half_edges.hpp"
#include "ciel/cell_geometry.hpp"
#include "ciel/parallel.hpp"
#include "ciel/vectors.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace ciel {

using namespace detail;

namespace {

Vec3d difference(const Vec3d& a, const Vec3d& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// Flags each vertex with a cell corner that is not convex by `margin`. Every other inner vertex has, in each direction,
// an adjacent vertex at least `margin` farther, so it cannot be an extremum of a plane distance.
class ReflexCorners {
public:
    ReflexCorners(const FaceMeshView& mesh, const Block& block, double margin, std::vector<std::uint8_t>& flag)
        : mesh_(mesh), block_(block), margin_(margin), flag_(flag) {}

    void run() {
        for (const StandardSection& section : block_.standard)
            with_shape(section.shape->type, [&]<const StandardShape & shape>() { standard<shape>(section); });
        block_.with([&](const auto& section) { polyhedra(section); });
    }

private:
    [[nodiscard]] Vec3d position(Index local) const { return ciel::position(mesh_, block_.vertex(local)); }

    // `around`: local vertices at the other ends of the corner's edges, in the order of next_around_face(mate_face(h)).
    void corner(Index vertex, std::span<const Index> around) {
        bool convex = around.size() >= 3;
        const Vec3d apex = position(vertex);
        for (std::size_t i = 2; i < around.size() && convex; ++i) {
            const Vec3d a = difference(position(around[0]), apex), b = difference(position(around[i - 1]), apex),
                        c = difference(position(around[i]), apex);
            const Vec3d area = cross(difference(b, a), difference(c, a));
            convex = dot(a, cross(b, c)) > margin_ * std::sqrt(dot(area, area)); // false for NaN
        }
        if (!convex) std::atomic_ref(flag_[block_.vertex(vertex)]).store(1, std::memory_order_relaxed);
    }

    template <const StandardShape& shape>
    void standard(const StandardSection& section) {
        const auto next = [](std::size_t h) {
            const std::size_t begin = shape.face_begin[shape.face[h]];
            return begin + (h - begin + 1) % shape.face_size(shape.face[h]);
        };
        for (std::size_t first = 0; first < section.vertex.size(); first += shape.corners)
            for (std::size_t c = 0; c < shape.corners; ++c) {
                around_.clear();
                const std::size_t start = shape.first_at_corner[c];
                std::size_t h = start;
                do {
                    around_.push_back(section.vertex[first + shape.target(h)]);
                    h = next(shape.mate[h]);
                } while (h != start);
                corner(section.vertex[first + c], around_);
            }
    }

    template <class Local>
    void polyhedra(const PolyhedralSection<Local>& section) {
        const Index half_edges = section.half_edge_count();
        Index left = half_edges;
        const auto next = [&](Index h) {
            const Index k = section.corner(h), side = section.side(h), face = section.face(k);
            return section.half_edge(side == 0 ? section.next_in_loop(k, face) : section.previous_in_loop(k, face),
                                     side);
        };
        const auto seen = [&](Index h) { return h >= half_edges || seen_[h] != 0; };
        const auto target = [&](Index h) {
            const Index k = section.corner(h);
            return Index{section.vertex[section.side(h) == 0 ? section.next_in_loop(k, section.face(k)) : k]};
        };
        seen_.assign(half_edges, 0);
        mate_.assign(half_edges, none);
        for (Index cell = 0; cell < section.count(); ++cell) {
            half_edges_.clear();
            // A changed record may have half-edges that do not exist, or that have no mate.
            (void)pairs_.run(section, cell, left, [&](Index h, Index mate, Index) {
                if (h >= half_edges || mate >= half_edges) return;
                mate_[h] = mate;
                half_edges_.push_back(h);
            });
            for (const Index start : half_edges_) {
                if (seen_[start] != 0) continue;
                around_.clear();
                for (Index h = start; !seen(h); h = mate_[h] == none ? none : next(mate_[h])) {
                    seen_[h] = 1;
                    around_.push_back(target(h));
                }
                corner(section.origin(start), around_);
            }
        }
    }

    const FaceMeshView& mesh_;
    const Block& block_;
    double margin_;
    std::vector<std::uint8_t>& flag_;
    std::vector<Index> around_;
    HalfEdgePairs pairs_;
    std::vector<Index> half_edges_; // of the current cell
    std::vector<Index> mate_;       // by half-edge of the section
    std::vector<std::uint8_t> seen_;
};

} // namespace

const GeometricVertices::Found& GeometricVertices::find(const Topology& topology) const {
    const Locked lock(mutex_);
    if (!mesh_) return found_;
    const FaceMeshView mesh = mesh_();
    double largest = 0;
    const Vec3d shift = mesh.surface_shift();
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        const Vec3d at = position(mesh, v), p{at[0] + shift[0], at[1] + shift[1], at[2] + shift[2]};
        largest = std::max(largest, dot(p, p));
    }
    found_.largest_distance = 4 * std::sqrt(largest);
    const double margin = found_.largest_distance * std::numeric_limits<float>::epsilon();
    std::vector<std::uint8_t> flag(mesh.vertex_count(), 0);
    for (Index face = 0; face < mesh.face_count(); ++face)
        if (mesh.neighbour[face] == none)
            for (const Index v : mesh.loop(face)) flag[v] = 1;
    const Topology::Blocks& blocks = topology.blocks();
    parallel_for(blocks.count(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b)
            ReflexCorners(mesh, blocks.cells(static_cast<Index>(b)), margin, flag).run();
    });
    found_.vertices.clear(); // an earlier call that ran out of memory may have left vertices
    for (Index v = 0; v < flag.size(); ++v)
        if (flag[v] != 0) found_.vertices.push_back(v);
    mesh_ = nullptr;
    return found_;
}

} // namespace ciel
