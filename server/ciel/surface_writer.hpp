// From the cut blocks to one indexed surface: ids by prefix sums, points in the mesh-wide order of their edges.
#pragma once

#include "ciel/cutter.hpp"
#include "ciel/field_blocks.hpp"

namespace ciel {

// `normals` makes the gradients at the ends of the active edges.
void write_surface(const Topology& topology, const FaceMeshView& mesh, const Field::Blocks& field, Cutter& cutter,
                   double nu, bool normals, Surface& out);

// The polygons' own direction where the gradient's is none, or the opposite of theirs taken together.
void mend_normals(Surface& surface);

} // namespace ciel
