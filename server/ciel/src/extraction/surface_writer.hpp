// Writes the cut blocks as one indexed surface (paper, algorithm 3: intersections, then polygons). Ids are prefix sums;
// points are in the mesh-wide order of their edges. Uses all threads of the parallel loop.
#pragma once

#include "extraction/cutter.hpp"
#include "fields/field_data.hpp"

#include <optional>

namespace ciel {

// The polygons and points of one block: both consecutive.
struct PointRange {
    Index polygon_begin, polygon_end, point_begin, point_end;
};

// Scratch of one query, kept so that the next surface allocates nothing.
struct SurfaceScratch {
    struct Share {
        Index point;
        Vec3d area;
    };
    std::vector<PointRange> ranges;
    std::vector<Vec3d> sum;                    // by point: sum of the areas of the polygons around it
    std::vector<std::vector<Share>> elsewhere; // by range: shares for points of other ranges
    std::vector<std::uint8_t> doubtful;        // by point
    std::vector<Index> renumbered;             // by point

    [[nodiscard]] std::size_t memory_bytes() const;
};

void write_surface(const Topology& topology, const FaceMeshView& mesh, const Field::Data& field, Cutter& cutter,
                   double nu, std::optional<Normals> normals, SurfaceScratch& scratch, Surface& out);

// Sets each normal to the area-weighted normal of the polygons around the point. Works per range of the scratch. The
// range that owns a point precedes the other ranges that use it.
void write_polygon_normals(SurfaceScratch& scratch, Surface& surface);

// Replaces zero or reversed gradient normals by the area-weighted polygon normal.
void mend_normals(SurfaceScratch& scratch, Surface& surface);

} // namespace ciel
