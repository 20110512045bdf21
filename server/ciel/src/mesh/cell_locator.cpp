#include "ciel/cell_locator.hpp"

#include "ciel/cell_geometry.hpp"
#include "ciel/vector_operators.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ciel {
namespace {

constexpr Index cells_per_box = 128; // runs of cells are compact: cells are in space-filling-curve order
constexpr double rounding = 1e-6;    // tolerance of `winding`, in units of 4 pi

// Solid angle of the triangle a, b, c seen from the origin, in steradians.
double solid_angle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const double la = length(a), lb = length(b), lc = length(c);
    const double volume = dot(a, cross(b, c));
    return 2 * std::atan2(volume, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

} // namespace

CellLocator::CellLocator(const FaceMeshView& mesh) : mesh_(mesh), faces_(cell_faces(mesh)) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    boxes_.assign((mesh_.cell_count() + cells_per_box - 1) / cells_per_box,
                  {Vec3d{infinity, infinity, infinity}, Vec3d{-infinity, -infinity, -infinity}});
    for (Index cell = 0; cell < mesh_.cell_count(); ++cell) {
        auto& [low, high] = boxes_[cell / cells_per_box];
        for (const Index face : faces_.of(cell))
            for (const Index vertex : mesh_.loop(face))
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double at = mesh_.positions[std::size_t{3} * vertex + axis];
                    low[axis] = std::min(low[axis], at);
                    high[axis] = std::max(high[axis], at);
                }
    }
}

template <class Vertices>
Vec3d CellLocator::centroid(const Vertices& vertices) const {
    Vec3d sum{};
    for (const Index vertex : vertices) {
        const Vec3d at = ciel::position(mesh_, vertex);
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += at[axis] / static_cast<double>(vertices.size());
    }
    return sum;
}

std::vector<Index> CellLocator::vertices(Index cell) const {
    std::vector<Index> all;
    for (const Index face : faces_.of(cell)) {
        const Ids loop = mesh_.loop(face);
        all.insert(all.end(), loop.begin(), loop.end());
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    if (all.empty()) mesh_.face_offset.refuse(); // a damaged mesh: each cell has vertices
    return all;
}

double CellLocator::winding(Index cell, const Vec3d& at) const {
    double angle = 0;
    for (const Index face : faces_.of(cell)) {
        const Ids loop = mesh_.loop(face);
        const Vec3d middle = centroid(loop) - at;
        double face_angle = 0;
        for (std::size_t k = 0; k < loop.size(); ++k)
            face_angle += solid_angle(middle, ciel::position(mesh_, loop[k]) - at,
                                      ciel::position(mesh_, loop[(k + 1) % loop.size()]) - at);
        angle += mesh_.owner[face] == cell ? face_angle : -face_angle;
    }
    return angle / (4 * std::numbers::pi);
}

Index CellLocator::cell_at(const Vec3d& position) const {
    const Vec3d at = position - mesh_.origin;
    Index best = none;
    double most = rounding;
    for (std::size_t box = 0; box < boxes_.size(); ++box) {
        const auto& [low, high] = boxes_[box];
        bool inside = true;
        for (std::size_t axis = 0; axis < 3; ++axis) inside = inside && low[axis] <= at[axis] && at[axis] <= high[axis];
        if (!inside) continue;
        const auto begin = static_cast<Index>(box * cells_per_box);
        for (Index cell = begin; cell < std::min(begin + cells_per_box, mesh_.cell_count()); ++cell) {
            const double here = winding(cell, at);
            if (here <= most) continue;
            most = here;
            best = cell;
        }
        if (most > 1 - rounding) break;
    }
    return best;
}

Index CellLocator::nearest_vertex(Index cell, const Vec3d& position) const {
    const Vec3d at = position - mesh_.origin;
    const auto all = vertices(cell);
    return *std::min_element(all.begin(), all.end(), [&](Index a, Index b) {
        return length(ciel::position(mesh_, a) - at) < length(ciel::position(mesh_, b) - at);
    });
}

VertexWeights CellLocator::weights_in(Index cell, const Vec3d& position) const {
    const Vec3d at = position - mesh_.origin;
    const auto all = vertices(cell);
    const Vec3d center = centroid(all);

    // Searches the tetrahedron in which the least barycentric weight of the point is largest. In a bent cell, the point
    // may lie slightly outside of all tetrahedra.
    std::array<double, 4> best{};
    double deepest = -std::numeric_limits<double>::infinity();
    Ids best_loop;
    Index best_a = none, best_b = none;
    for (const Index face : faces_.of(cell)) {
        const Ids loop = mesh_.loop(face);
        const Vec3d middle = centroid(loop) - center;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Index a = loop[k], b = loop[(k + 1) % loop.size()];
            const Vec3d pa = ciel::position(mesh_, a) - center, pb = ciel::position(mesh_, b) - center, p = at - center;
            const double volume = dot(middle, cross(pa, pb));
            if (volume == 0) continue;
            const double wf = dot(p, cross(pa, pb)) / volume;
            const double wa = dot(middle, cross(p, pb)) / volume;
            const double wb = dot(middle, cross(pa, p)) / volume;
            const std::array<double, 4> shares{1 - wf - wa - wb, wf, wa, wb};
            const double depth = *std::min_element(shares.begin(), shares.end());
            if (!(depth > deepest)) continue;
            deepest = depth;
            best = shares;
            best_loop = loop;
            best_a = a;
            best_b = b;
        }
    }
    VertexWeights weights;
    if (best_a == none) return {{nearest_vertex(cell, position), 1}}; // the cell has no volume
    for (const Index vertex : all) weights.emplace_back(vertex, best[0] / static_cast<double>(all.size()));
    for (const Index vertex : best_loop) weights.emplace_back(vertex, best[1] / static_cast<double>(best_loop.size()));
    weights.emplace_back(best_a, best[2]);
    weights.emplace_back(best_b, best[3]);
    return weights;
}

} // namespace ciel
