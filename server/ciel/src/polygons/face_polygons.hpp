// Makes a surface from faces of the mesh, which the caller adds one by one. Not in the paper.
#pragma once

#include "ciel/cell_geometry.hpp"
#include "ciel/threshold_surface.hpp"
#include "fields/sparse_array.hpp"

#include <algorithm>
#include <span>

namespace ciel::detail {

class FacePolygons {
public:
    explicit FacePolygons(const FaceMeshView& points, CollapsedFaces collapsed = CollapsedFaces::leave_out)
        : points_(points), collapsed_(collapsed), used_(points.vertex_count()) {}

    // Adds a polygon. `loop`: wound outwards from `cell`. `face`: the entry of the polygon in Surface::polygon_face.
    void add(std::span<const Index> loop, Index cell, Index face) {
        if (collapsed_ == CollapsedFaces::leave_out && !is_polygon(loop)) return;
        points_.load(loop);
        for (const Index vertex : loop) add_corner(vertex);
        surface_.polygon_offset.push_back(static_cast<Index>(surface_.polygon_vertex.size()));
        surface_.polygon_cell.push_back(cell);
        surface_.polygon_face.push_back(face);
    }
    [[nodiscard]] Surface take() &&; // returns the surface and sets its chunks

private:
    [[nodiscard]] static bool is_polygon(std::span<const Index> loop) {
        Index other = none; // the second distinct vertex, once found
        for (const Index vertex : loop) {
            if (vertex == loop[0] || vertex == other) continue;
            if (other != none) return true;
            other = vertex;
        }
        return false;
    }
    void add_corner(Index vertex) {
        Index& point = used_.get()[vertex];
        if (point == 0) {
            surface_.positions.push_back(surface_position(points_, vertex));
            surface_.points.push_back({vertex, vertex, 0});
            point = static_cast<Index>(surface_.points.size());
        }
        surface_.polygon_vertex.push_back(point - 1);
    }

    const FaceMeshView& points_;
    CollapsedFaces collapsed_;
    SparseArray<Index> used_; // by mesh vertex: index in surface_.points plus 1; 0 if not added
    Surface surface_;
};

// Divides the polygons of a surface into chunks. For a surface that was made polygon by polygon.
void add_chunks(Surface& surface);

} // namespace ciel::detail
