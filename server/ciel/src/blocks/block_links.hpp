// Ties finished blocks together (paper, appendix A: faces find their counterpart, vertices their lists): ids by prefix
// sums, the rings of shared vertices, owners of shared edges, twins.
#pragma once

#include "blocks/block_builder.hpp"

namespace ciel {

// Takes the blocks out of `built`, which are those of `mesh` in order. Fills `out` but for counts.faces,
// boundary_faces, cells and components. Throws Error when ids do not fit 32 bits.
void link_blocks(const FaceMeshView& mesh, std::vector<BuiltBlock>& built, Topology::Blocks& out);

} // namespace ciel
