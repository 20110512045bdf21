// Ties finished blocks together: ids by prefix sums, the rings of shared vertices, owners of shared edges, twins.
#pragma once

#include "ciel/block_builder.hpp"

namespace ciel {

// Fills `out` but for counts.faces, boundary_faces, cells and components. Throws Error when ids do not fit 32 bits.
void link_blocks(const FaceMeshView& mesh, std::vector<BuiltBlock>& built, Topology::Blocks& out);

} // namespace ciel
