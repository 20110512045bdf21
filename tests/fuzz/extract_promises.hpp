// Checks the contracts of extract.hpp and related headers, for any mesh and field.
#pragma once

#include "ciel/clip_surface.hpp"
#include "ciel/contour_lines.hpp"
#include "ciel/feature_edges.hpp"
#include "ciel/polygon_edges.hpp"
#include "ciel/threshold_surface.hpp"
#include "color/slab_triangles.hpp"
#include "fuzz/bytes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace ciel::test {
using namespace server;

[[nodiscard]] inline std::span<const Index> corners(const Surface& surface, std::size_t i) {
    const Index begin = surface.polygon_offset[i];
    return std::span(surface.polygon_vertex).subspan(begin, surface.polygon_offset[i + 1] - begin);
}

inline void same_surface(const Surface& a, const Surface& b, const char* what) {
    require(same_bits(a.points, b.points) && same_bits(a.positions, b.positions) && same_bits(a.normals, b.normals) &&
                same_bits(a.polygon_offset, b.polygon_offset) && same_bits(a.polygon_vertex, b.polygon_vertex) &&
                same_bits(a.polygon_cell, b.polygon_cell),
            what);
}

inline void check_polygons(const Surface& surface, Index cells) {
    const std::size_t polygons = surface.polygon_cell.size();
    require(surface.polygon_offset.size() == polygons + 1 && surface.polygon_offset[0] == 0, "polygon_offset");
    require(surface.polygon_offset.back() == surface.polygon_vertex.size(), "the end of polygon_offset");
    for (std::size_t i = 0; i < polygons; ++i) {
        require(surface.polygon_cell[i] < cells, "a polygon of no cell");
        require(surface.polygon_offset[i + 1] >= surface.polygon_offset[i] + 3, "a polygon of two corners");
        for (const Index p : corners(surface, i)) require(p < surface.positions.size(), "a corner without a point");
    }
    require(surface.normals.empty() || surface.normals.size() == surface.positions.size(), "as many normals as points");
    for (const Vec3f& n : surface.normals) {
        const double length = std::hypot(n[0], n[1], n[2]);
        require(length == 0 || std::abs(length - 1) < 1e-4, "a normal that is not unit");
    }
    for (const Index v : triangulate(surface)) require(v < surface.positions.size(), "a triangle without a point");
}

inline void check_cut(const Surface& surface, const FaceMeshView& mesh, std::span<const float> values, double nu) {
    check_polygons(surface, mesh.cell_count());
    require(surface.points.size() == surface.positions.size(), "as many points as positions");
    std::vector<bool> used(surface.points.size(), false);
    for (const Index p : surface.polygon_vertex) used[p] = true;
    require(std::ranges::find(used, false) == used.end(), "a point that no polygon has");
    require(std::ranges::is_sorted(surface.polygon_cell), "polygons are in the order of cells");
    for (const auto& [a, b, t] : surface.points) {
        require(a < b && b < mesh.vertex_count(), "a point off every edge");
        require(std::isfinite(values[a]) && std::isfinite(values[b]), "a point through no value");
        require((values[a] >= nu) != (values[b] >= nu), "a point on an edge that is not active");
        require(t >= 0 && t <= 1, "a point beyond its edge");
    }
}

// An edge without an opposite one in another polygon must lie on a face that has only one cut cell.
inline void check_closed(const Surface& surface, const FaceMeshView& mesh, std::span<const float> values) {
    std::map<std::pair<Index, Index>, int> open;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        Index before = corners(surface, i).back();
        for (const Index p : corners(surface, i)) {
            if (p != before) open[std::minmax(p, before)] += p < before ? 1 : -1;
            before = p;
        }
    }
    std::erase_if(open, [](const auto& side) { return side.second == 0; });
    if (open.empty()) return;
    std::vector<bool> cut(mesh.cell_count(), true);
    for (Index f = 0; f < mesh.face_count(); ++f)
        if (std::ranges::any_of(mesh.loop(f), [&](Index v) { return !std::isfinite(values[v]); }))
            for (const Index cell : {mesh.owner[f], mesh.neighbour[f]})
                if (cell != none) cut[cell] = false;
    // Maps each mesh edge to the faces between a cut cell and an uncut one or the outside.
    std::map<std::pair<Index, Index>, std::set<Index>> faces_of;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const bool owner = cut[mesh.owner[f]], neighbour = mesh.neighbour[f] != none && cut[mesh.neighbour[f]];
        if (owner && neighbour) continue;
        const auto loop = mesh.loop(f);
        for (std::size_t k = 0; k < loop.size(); ++k)
            faces_of[std::minmax(loop[k], loop[(k + 1) % loop.size()])].insert(f);
    }
    for (const auto& [side, count] : open) {
        const auto& first = faces_of[{surface.points[side.first].a, surface.points[side.first].b}];
        const auto& second = faces_of[{surface.points[side.second].a, surface.points[side.second].b}];
        require(std::ranges::any_of(first, [&](Index f) { return second.contains(f); }), "the surface is open inside");
    }
}

// Number of contour lines: each run of high vertices of a polygon gives one segment.
inline std::size_t expected_lines(const Surface& surface, std::span<const float> values, std::span<const double> at) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        const auto loop = corners(surface, i);
        if (!std::ranges::all_of(loop, [&](Index p) { return std::isfinite(values[p]); })) continue;
        for (const double nu : at)
            for (std::size_t k = 0; k < loop.size(); ++k)
                if (values[loop[k]] < nu && values[loop[(k + 1) % loop.size()]] >= nu) ++count;
    }
    return count;
}

inline void check_edges(const Surface& surface) {
    const std::vector<Index> edges = polygon_edges(surface), bends = feature_edges(surface, 30);
    std::set<std::pair<Index, Index>> all;
    require(edges.size() % 2 == 0 && bends.size() % 2 == 0, "half an edge");
    for (std::size_t i = 0; i < edges.size(); i += 2) {
        require(edges[i] < edges[i + 1] && edges[i + 1] < surface.positions.size(), "an edge between no points");
        require(all.empty() || *all.rbegin() < std::pair(edges[i], edges[i + 1]), "edges ascend");
        all.emplace_hint(all.end(), edges[i], edges[i + 1]);
    }
    for (std::size_t i = 0; i < bends.size(); i += 2)
        require(all.contains({bends[i], bends[i + 1]}), "a feature edge that is no edge");
}

inline void check_clipped(const ClippedSurface& clipped, std::size_t points_before, std::span<const HalfSpace> planes,
                          double slack, Index cells) {
    const Surface& surface = clipped.surface;
    check_polygons(surface, cells);
    require(surface.points.size() <= points_before, "points that were not there");
    require(clipped.values.size() == surface.positions.size(), "as many values as positions");
    for (const Vec3f& p : surface.positions)
        for (const HalfSpace& plane : planes) {
            double distance = plane.offset, size = std::abs(plane.offset);
            for (std::size_t d = 0; d < 3; ++d) {
                distance += plane.normal[d] * p[d];
                size += std::abs(plane.normal[d] * p[d]);
            }
            if (std::isfinite(distance)) require(distance >= -slack - 1e-5 * size, "what was clipped away is there");
        }
}

inline void check_slab(const color::SlabTriangles& slab) {
    require(slab.triangles.size() % 3 == 0, "whole triangles");
    for (std::size_t i = 0; i < slab.triangles.size(); ++i) {
        require(slab.triangles[i] < slab.vertices.size(), "a slab's triangle without a vertex");
        const color::SlabVertex& v = slab.vertices[slab.triangles[i]];
        require(std::isfinite(v.value), "a slab's triangle without a value");
        require(i % 3 != 0 || (v.limits[0] <= v.limits[1] && std::isfinite(v.limits[0]) && std::isfinite(v.limits[1])),
                "limits the wrong way round, or not finite");
    }
}

} // namespace ciel::test
