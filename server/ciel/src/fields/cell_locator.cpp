#include "ciel/cell_locator.hpp"

#include "blocks/blocks.hpp"
#include "blocks/cell_loops.hpp"
#include "blocks/load_vertices.hpp"
#include "ciel/cell_geometry.hpp"
#include "ciel/vector_operators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace ciel {

using namespace detail;

namespace {

constexpr double rounding = 1e-6; // tolerance for a result of `winding`

// Returns the signed solid angle of the triangle a, b, c seen from the origin, in steradians.
double solid_angle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const double la = length(a), lb = length(b), lc = length(c);
    const double volume = dot(a, cross(b, c));
    return 2 * std::atan2(volume, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

Vec3d centroid(const FaceMeshView& points, std::span<const Index> vertices) {
    Vec3d sum{};
    for (const Index vertex : vertices) {
        const Vec3d at = position(points, vertex);
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += at[axis] / static_cast<double>(vertices.size());
    }
    return sum;
}

bool box_holds(const BlockBoxes& boxes, Index block, const Vec3d& at) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (!(boxes[axis].low[block] <= at[axis] && at[axis] <= boxes[axis].high[block])) return false;
    return true;
}

bool box_holds(const FaceMeshView& points, const CellLoops& loops, const Vec3d& at) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        bool below = false, above = false;
        for (const Index vertex : loops.vertex) {
            const double coordinate = points.positions[std::size_t{3} * vertex + axis];
            below = below || coordinate <= at[axis];
            above = above || coordinate >= at[axis];
        }
        if (!below || !above) return false;
    }
    return true;
}

// Returns 1 inside the cell and 0 outside: the sum of the solid angles of the faces seen from `at`, over 4 pi.
double winding(const FaceMeshView& points, const CellLoops& loops, const Vec3d& at) {
    double angle = 0;
    for (std::size_t face = 0; face < loops.count(); ++face) {
        const auto loop = loops.face(face);
        const Vec3d middle = centroid(points, loop) - at;
        for (std::size_t k = 0; k < loop.size(); ++k)
            angle +=
                solid_angle(middle, position(points, loop[k]) - at, position(points, loop[(k + 1) % loop.size()]) - at);
    }
    return angle / (4 * std::numbers::pi);
}

struct Cell {
    CellLoops loops;
    std::vector<Index> vertices; // ascending
};

Cell cell_of(const Topology& topology, const FaceMeshView& points, Index cell) {
    const Topology::Blocks& blocks = topology.blocks();
    if (cell >= topology.counts().cells) fail("the mesh has no cell " + std::to_string(cell));
    const Index b = blocks.block_of_cell(cell);
    const Block& block = blocks.cells(b);
    load_vertices(points.loader, b, block);
    Cell found;
    read_loops(block, cell - block.cell_begin, found.loops);
    found.vertices = found.loops.vertex;
    std::ranges::sort(found.vertices);
    found.vertices.erase(std::unique(found.vertices.begin(), found.vertices.end()), found.vertices.end());
    if (found.vertices.empty()) refuse_changed("a cell has no faces");
    return found;
}

Index nearest_of(const FaceMeshView& points, std::span<const Index> vertices, const Vec3d& at) {
    return *std::ranges::min_element(vertices, {}, [&](Index vertex) { return length(position(points, vertex) - at); });
}

} // namespace

CellLocator::CellLocator(const Topology& topology, const FaceMeshView& points, std::shared_ptr<const BlockBoxes> boxes)
    : topology_(topology), points_(points.owned()), boxes_(std::move(boxes)) {
    if (points_.vertex_count() != topology.counts().vertices || (*boxes_)[0].low.size() != topology.block_count())
        fail("the positions or the boxes do not fit the topology; pass the positions and boxes of the same mesh");
}

Index CellLocator::cell_at(const Vec3d& position) const {
    const Topology::Blocks& blocks = topology_.blocks();
    const Vec3d at = position - points_.origin;
    CellLoops loops;
    Index best = none;
    double most = rounding;
    for (Index b = 0; b < blocks.count() && most <= 1 - rounding; ++b) {
        if (!box_holds(*boxes_, b, at)) continue;
        const Block& block = blocks.cells(b);
        load_vertices(points_.loader, b, block);
        for_cells(block, loops, [&](Index cell, const CellLoops& of_cell) {
            if (!box_holds(points_, of_cell, at)) return;
            const double here = winding(points_, of_cell, at);
            if (!(here > most)) return; // also for NaN, of a cell with a vertex that is not finite
            most = here;
            best = cell;
        });
    }
    return best;
}

Index CellLocator::nearest_vertex(Index cell, const Vec3d& position) const {
    return nearest_of(points_, cell_of(topology_, points_, cell).vertices, position - points_.origin);
}

VertexWeights CellLocator::weights_in(Index cell, const Vec3d& position) const {
    const Vec3d at = position - points_.origin;
    const Cell of = cell_of(topology_, points_, cell);
    // The weights below would keep rounding errors of the other vertices, so that the value would not be the stored
    // one.
    for (const Index vertex : of.vertices)
        if (ciel::position(points_, vertex) == at) return {{vertex, 1}};
    const Vec3d center = centroid(points_, of.vertices);

    // Divides the cell into tetrahedra. The corners of a tetrahedron are the center of the cell, the center of a face,
    // and the ends of an edge of this face. Chooses the tetrahedron whose smallest weight is the greatest. This weight
    // may be negative, because the point may lie slightly outside all tetrahedra of a bent cell.
    std::array<double, 4> best{};
    double deepest = -std::numeric_limits<double>::infinity();
    std::span<const Index> best_loop;
    Index best_a = none, best_b = none;
    for (std::size_t face = 0; face < of.loops.count(); ++face) {
        const auto loop = of.loops.face(face);
        const Vec3d middle = centroid(points_, loop) - center;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Index a = loop[k], b = loop[(k + 1) % loop.size()];
            const Vec3d pa = ciel::position(points_, a) - center, pb = ciel::position(points_, b) - center,
                        p = at - center;
            const double volume = dot(middle, cross(pa, pb));
            if (volume == 0) continue;
            const double wf = dot(p, cross(pa, pb)) / volume;
            const double wa = dot(middle, cross(p, pb)) / volume;
            const double wb = dot(middle, cross(pa, p)) / volume;
            const std::array<double, 4> shares{1 - wf - wa - wb, wf, wa, wb};
            const double depth = std::ranges::min(shares);
            if (!(depth > deepest)) continue;
            deepest = depth;
            best = shares;
            best_loop = loop;
            best_a = a;
            best_b = b;
        }
    }
    VertexWeights weights;
    if (best_a == none) return {{nearest_of(points_, of.vertices, at), 1}}; // the cell has no volume
    for (const Index vertex : of.vertices)
        weights.emplace_back(vertex, best[0] / static_cast<double>(of.vertices.size()));
    for (const Index vertex : best_loop) weights.emplace_back(vertex, best[1] / static_cast<double>(best_loop.size()));
    weights.emplace_back(best_a, best[2]);
    weights.emplace_back(best_b, best[3]);
    return weights;
}

} // namespace ciel
