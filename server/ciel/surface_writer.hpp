// From the cut blocks to one indexed surface: ids by prefix sums, points in the mesh-wide order of their edges.
#pragma once

#include "ciel/cutter.hpp"
#include "ciel/field_blocks.hpp"

#include <optional>

namespace ciel {

// Scratch of one query: the polygons' areas around the points of a surface.
struct NormalSums {
    struct Share {
        Index point;
        Vec3d area;
    };
    std::vector<Vec3d> sum;                    // by point
    std::vector<std::vector<Share>> elsewhere; // by chunk: what belongs to points of others
};

void write_surface(const Topology& topology, const FaceMeshView& mesh, const Field::Blocks& field, Cutter& cutter,
                   double nu, std::optional<Normals> normals, NormalSums& sums, Surface& out);

// Sums up what polygons have around each of the surface's points. `chunks`: consecutive polygons and points that are
// made together, in order; a point's owner comes first of those that use it.
struct PointRange {
    Index polygon_begin, polygon_end, point_begin, point_end;
};
void write_polygon_normals(std::span<const PointRange> chunks, NormalSums& sums, Surface& surface);

// The polygons' own direction where the gradient's is none, or the opposite of theirs taken together.
void mend_normals(Surface& surface);

} // namespace ciel
