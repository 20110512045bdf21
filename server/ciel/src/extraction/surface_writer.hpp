// Writes the cuts of all blocks as one indexed surface (paper, algorithm 3: first intersections, then polygons). Points
// are in the order of mesh-wide edge ids. Uses all threads of parallel_for.
#pragma once

#include "extraction/adopted_edges.hpp"
#include "fields/field_data.hpp"

#include <optional>

namespace ciel::detail {

// Indices of the polygons and the points of one block in a surface. Both are consecutive.
struct PointRange {
    Index polygon_begin, polygon_end, point_begin, point_end;
};

// Buffers of one Query. They are kept, so that the next surface allocates no memory.
struct SurfaceScratch {
    struct Share {
        Index point;
        Vec3d area;
    };
    AdoptedEdges adopted;
    std::vector<PointRange> ranges;
    std::vector<Vec3d> sum;                    // by point: sum of the area vectors of the polygons around it
    std::vector<std::vector<Share>> elsewhere; // by range: area vectors of its polygons, for points of other ranges
    std::vector<std::uint8_t> doubtful;        // by point: 1 if the gradient normal may be unusable
    std::vector<Index> renumbered;             // by point: new index, or none if the point is in no polygon

    [[nodiscard]] std::size_t memory_bytes() const;
};

void write_surface(const Topology& topology, const FaceMeshView& mesh, const Field::Data& field, Cutter& cutter,
                   double nu, std::optional<Normals> normals, SurfaceScratch& scratch, Surface& out);

// Sets each normal to the mean of the normals of the polygons around the point, weighted by area. REQUIRES:
// scratch.ranges is set, and has the range that owns a point before the other ranges that use the point.
void write_polygon_normals(SurfaceScratch& scratch, Surface& surface);

// Corrects gradient normals. The polygon normal of a point is the mean of the normals of the polygons around the point,
// weighted by area. It replaces a gradient normal that is zero or points against the polygon normal.
void mend_normals(SurfaceScratch& scratch, Surface& surface);

} // namespace ciel::detail
