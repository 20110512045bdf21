// From the cut blocks to one indexed surface (paper, algorithm 3: intersections, then polygons): ids by prefix sums,
// points in the mesh-wide order of their edges. Uses all threads of the parallel loop.
#pragma once

#include "extraction/cutter.hpp"
#include "fields/field_data.hpp"

#include <optional>

namespace ciel {

// Polygons and points that are made together: both consecutive.
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
    std::vector<Vec3d> sum;                    // of the polygons' areas around a point, by point
    std::vector<std::vector<Share>> elsewhere; // by range: what belongs to points of others
    std::vector<std::uint8_t> doubtful;        // by point
    std::vector<Index> renumbered;             // by point

    [[nodiscard]] std::size_t memory_bytes() const;
};

void write_surface(const Topology& topology, const FaceMeshView& mesh, const Field::Data& field, Cutter& cutter,
                   double nu, std::optional<Normals> normals, SurfaceScratch& scratch, Surface& out);

// Sums up what polygons have around each of the surface's points, range by range of the scratch; a point's owner comes
// first of those that use it.
void write_polygon_normals(SurfaceScratch& scratch, Surface& surface);

// The polygons' own direction where the gradient's is none, or the opposite of theirs taken together.
void mend_normals(SurfaceScratch& scratch, Surface& surface);

} // namespace ciel
