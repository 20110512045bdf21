// Writes the cuts of all blocks as one indexed surface (paper, algorithm 3: intersections, then polygons). Prefix sums
// over the blocks give the first ids of each block; points are in the order of mesh-wide edge ids. Uses all threads of
// the parallel loop.
#pragma once

#include "extraction/adopted_edges.hpp"
#include "fields/field_data.hpp"

#include <optional>

namespace ciel {

// Ids of the polygons and points of one block in a surface. Both are consecutive.
struct PointRange {
    Index polygon_begin, polygon_end, point_begin, point_end;
};

// Scratch of one query, kept so that the next surface allocates nothing.
struct SurfaceScratch {
    struct Share {
        Index point;
        Vec3d area;
    };
    AdoptedEdges adopted;
    std::vector<PointRange> ranges;
    std::vector<Vec3d> sum;                    // by point: sum of the area vectors of the polygons around it
    std::vector<std::vector<Share>> elsewhere; // by range: area vectors of its polygons at points of other ranges
    std::vector<std::uint8_t> doubtful;        // by point: 1 if the gradient normal may be unusable
    std::vector<Index> renumbered;             // by point: new index, or none if in no polygon

    [[nodiscard]] std::size_t memory_bytes() const;
};

void write_surface(const Topology& topology, const FaceMeshView& mesh, const Field::Data& field, Cutter& cutter,
                   double nu, std::optional<Normals> normals, SurfaceScratch& scratch, Surface& out);

// Sets each normal to the area-weighted normal of the polygons around the point. Requires scratch.ranges, in which the
// range that owns a point comes before the other ranges that use the point.
void write_polygon_normals(SurfaceScratch& scratch, Surface& surface);

// Replaces zero or reversed gradient normals by the area-weighted polygon normal.
void mend_normals(SurfaceScratch& scratch, Surface& surface);

} // namespace ciel
