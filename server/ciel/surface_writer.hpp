// From the cut blocks to one indexed surface: ids by prefix sums, points in the mesh-wide order of their edges.
#pragma once

#include "ciel/cutter.hpp"
#include "ciel/field_blocks.hpp"

namespace ciel {

// Everything of `out` but the normals.
void write_surface(const Topology& topology, const FaceMeshView& mesh, const Field::Blocks& field, Cutter& cutter,
                   double nu, Surface& out);

// Along the field's gradient; where that is zero, the mean normal of the polygons around the point.
void write_normals(const FaceMeshView& mesh, const Field::Blocks& field, Surface& out);

} // namespace ciel
