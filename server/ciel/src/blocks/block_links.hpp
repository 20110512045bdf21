// Links finished blocks (paper, appendix A: faces find their counterpart, vertices their lists). Assigns mesh-wide ids,
// links the blocks of each shared vertex in a ring, and finds the owners of shared edges and the twins of faces.
#pragma once

#include "blocks/block_builder.hpp"

namespace ciel {

// Moves the blocks of `built`, which are all blocks of `mesh` in order, to `out`. Sets all of `out` except
// counts.faces, boundary_faces, cells and components. Throws Error when ids do not fit 32 bits.
void link_blocks(const FaceMeshView& mesh, std::vector<BuiltBlock>& built, Topology::Blocks& out);

} // namespace ciel
